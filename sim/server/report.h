#pragma once

#include <cstdint>
#include <string>

#include "sim/server/pacer.h"
#include "sim/server/server.h"

namespace server {

/// Troubles since the start: what was refused, what was not sent, how much time could not be kept.
struct Troubles {
  PortCounts control;
  world::PerTeam<PortCounts> robots;
  std::uint64_t not_sent = 0;        ///< datagrams that the system did not take
  Pacer::Clock::duration skipped{};  ///< of the schedule
  double speed = 1;                  ///< in force when time could last not be kept
};

/// What is new in `now`, for people; empty when nothing is.
std::string news(const Troubles& before, const Troubles& now);

}  // namespace server

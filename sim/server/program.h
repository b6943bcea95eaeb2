#pragma once

#include <atomic>
#include <iosfwd>

#include "sim/server/options.h"

namespace server {

/// Runs the simulator in real time on the network, until `stop` or until the duration has passed.
///
/// Prints one line to `out` when everything listens and one with counts at the end; troubles go to `err`, at
/// most one line a second.
///
/// @throws std::invalid_argument for bad options, network::NetworkError when an address cannot be used
void run(const Options& options, const std::atomic<bool>& stop, std::ostream& out, std::ostream& err);

}  // namespace server

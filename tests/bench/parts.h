#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tests/bench/recording.h"

namespace hot {

/// One part of a tick, run over a recorded game from its first tick on.
class Runner {
 public:
  virtual ~Runner() = default;
  /// What it needs for this tick but what is not measured.
  virtual void prepare(const Tick&) {}
  virtual void run(const Tick& tick) = 0;
};

struct PartOfTick {
  std::string name;
  std::unique_ptr<Runner> (*make)(const Recording& recording);
};

/// All parts that are measured: engine, vision, tracker, touch, automaton, referee, encode, decode, channel,
/// session, team.
const std::vector<PartOfTick>& parts();

}  // namespace hot

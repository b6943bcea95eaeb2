#pragma once

#include <array>

#include "sim/world/random.h"
#include "sim/world/robot_id.h"

namespace rough {

/// Decides, once per opportunity, whether a robot gives way to a habit, and whether it then stops just short
/// of the limit; the decision holds until the opportunity is over.
class Temptation {
 public:
  /// @param opportunity  whether there is one for this robot in this tick
  /// @param rate         chance to give way [0..1]
  /// @param restraint    chance that it stays just lawful when it gives way [0..1]
  bool gives_way(int robot, bool opportunity, double rate, world::RandomStream& stream, double restraint = 0);
  /// Of who gave way: it only nearly offends.
  bool holds_back(int robot) const { return states_[static_cast<std::size_t>(robot)].holds_back; }
  /// Every opportunity is over.
  void end() { states_ = {}; }

 private:
  struct State {
    bool open = false;
    bool gave_way = false;
    bool holds_back = false;
  };
  std::array<State, world::max_robot_number + 1> states_{};
};

}  // namespace rough

#pragma once

#include <array>
#include <optional>
#include <vector>

#include "experiments/judge/laws/moment.h"
#include "experiments/judge/laws/window.h"

namespace judge {

/// What robots may not do while play is stopped (Laws 5, 9, 12): drive too fast, stay near a ball that
/// lies, stay in the way of a ball that is to be placed.
///
/// All three need some time: the speed was above its limit for the whole of it, the distance below its limit.
/// One event of each kind per robot and stoppage.
/// Margins  how much the best moment of the worst such stretch was beyond the limit.
class Stops {
 public:
  void watch(const Moment& moment, std::vector<TrueEvent>& out);
  /// Play is restarted, or the game is over.
  void finish(std::vector<TrueEvent>& out);

 private:
  struct Watched {
    Window window;
    std::optional<TrueEvent> worst{};
    bool passed = false;
  };
  struct OfRobot {
    Watched speed, near, way;
  };
  void begin(const Moment& moment);
  void note(const Moment& moment, Event event, const truth::Robot& robot, double beyond, double band,
            Watched& watched) const;

  bool stop_ = false;
  std::uint32_t counter_ = 0;  // of the command
  std::optional<world::Vector2d> lies_at_;
  std::array<OfRobot, robot_slots> robots_;
};

}  // namespace judge

#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "autoref/touch/touch_detector.h"
#include "experiments/judge/true_touches.h"
#include "sim/world/game_state.h"

namespace judge {

/// One way to say who touched the ball, fed with the acting referee's frames and images: a row of the
/// paper's Table 8, ours, or the baseline.
class Witness {
 public:
  Witness(std::string name, const world::Geometry& geometry, world::TouchAlgorithms algorithms);
  /// The baseline: whoever is nearest to the ball in the last frame in which a robot was within 150 mm of it
  /// (Utama's autoref: reference "football", 4.2).
  static Witness nearest(const world::Geometry& geometry);

  const std::string& name() const { return name_; }
  void see(const world::TrackedFrame& frame, std::span<const world::Detection> images,
           const world::GameState& state);
  /// The last touch of the ball in play.
  const std::optional<world::Touch>& last() const { return last_; }
  /// Every touch it named in this game; one robot's are joined when less than 50 ms apart.
  struct Named {
    world::RobotId robot;
    world::Time begin, end;
    bool in_play = false;
  };
  const std::vector<Named>& named() const { return named_; }

 private:
  void keep(const world::Touch& touch, bool in_play);

  std::string name_;
  world::Field field_;
  std::optional<touch::TouchDetector> detector_;  // or else the nearest robot
  std::vector<world::Touch> found_;
  std::optional<world::Touch> last_;
  std::vector<Named> named_;
  world::Time last_frame_;
  world::Location location_{};
  std::optional<world::Time> play_began_;
};

/// The witnesses of Table 8 and the baseline: accel, with line, with backtrack, all three, likelihood,
/// nearest robot.
std::vector<Witness> all_witnesses(const world::Geometry& geometry);

/// How many touches of each kind a witness found; both windows of the paper's kind, 0.1 s and 0.3 s.
struct TouchCount {
  std::string witness;
  double window = 0;  ///< [s]
  std::array<int, kinds> found{};
  std::array<int, kinds> missed{};
  int extra = 0;  ///< named, and none there
  int own = 0;    ///< true ones with a named one that stands for no other
  int again = 0;  ///< named once more within a touch that was found
};
/// A named touch stands for every true one of the same robot that it overlaps (contact that lasts is named
/// without a pause), and else for the nearest one within `window`, one to one.
TouchCount count_touches(const std::deque<TrueTouch>& truth, const Witness& witness, double window);

}  // namespace judge

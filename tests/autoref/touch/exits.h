#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "autoref/touch/touch_detector.h"
#include "sim/world/game_state.h"
#include "tests/autoref/touch/true_touches.h"

namespace study {

/// One way to say who touched the ball, fed with the referee's frames beside the referee.
class Witness {
 public:
  Witness(std::string name, const world::Field& field, world::TouchAlgorithms algorithms);
  /// The baseline: whoever is nearest to the ball in the last frame in which a robot was within 150 mm of it
  /// (Utama's autoref: football.md 4.2).
  static Witness nearest(const world::Field& field);

  const std::string& name() const { return name_; }
  /// @param play_began  nothing when the ball is not in play
  void update(const world::TrackedFrame& frame, std::span<const world::Detection> images,
              std::optional<world::Time> play_began);
  const std::optional<world::Touch>& last() const { return last_; }
  /// Play begins, with a kick by that robot or without one.
  void begin(std::optional<world::RobotId> kicker, world::Time when);

 private:
  std::string name_;
  world::Field field_;
  std::optional<touch::TouchDetector> detector_;  // or else the nearest robot
  std::vector<world::Touch> found_;
  std::optional<world::Touch> last_;
  world::Time last_frame_;
};

/// A ball that left the field in play, and who each witness says was the last to touch it.
struct Exit {
  world::Time time;
  world::RobotId toucher;  ///< in truth
  Kind kind{};             ///< of the last touch
  bool ambiguous = false;  ///< in truth: robots of both teams touched it within one frame
  bool at_line = false;    ///< the last touch was less than two ticks before the ball was out, or during it
  bool goal = false;       ///< into a goal
  bool chip = false;       ///< higher than a robot since the last touch
  double earlier = 0;      ///< [s] from the last touch to the exit
  std::vector<std::optional<world::Touch>> said;  ///< by witness
};

/// Watches a game: truth, frames and state of the referee, tick by tick.
class ExitStudy {
 public:
  ExitStudy(const world::Field& field, std::vector<Witness> witnesses);

  /// @param frame  null when this tick brought none
  void tick(const truth::Frame& truth, const world::TrackedFrame* frame,
            std::span<const world::Detection> images, const world::GameState& state);

  const std::vector<Exit>& exits() const { return exits_; }
  const std::vector<Witness>& witnesses() const { return witnesses_; }
  const TrueTouches& touches() const { return touches_; }

 private:
  void decide(const world::TrackedFrame& frame);

  world::Field field_;
  std::vector<Witness> witnesses_;
  TrueTouches touches_;
  std::vector<Exit> exits_;
  std::optional<Exit> pending_;  // until the referee would decide it
  world::Location location_{};
  std::optional<world::Time> play_began_;
  int seen_outside_ = 0;  // frames in a row
  bool armed_ = false;    // in play and not yet out
};

/// The witnesses of the study: the rows of the paper's Table 8, ours, and the baseline.
std::vector<Witness> all_witnesses(const world::Field& field);

/// Wilson's interval of `successes` of `n`, 95 %.
struct Interval {
  double low = 0, high = 1;
};
Interval wilson(int successes, int n);

/// Two-sided exact McNemar test: `b` and `c` are the pairs in which only one was right.
double mcnemar(int b, int c);

/// The table of the README, as Markdown.
std::string table(const std::vector<Exit>& exits, const std::vector<Witness>& witnesses);

/// How often the likelihood's team was right, by the probability it named.
std::string calibration(const std::vector<Exit>& exits, const std::vector<Witness>& witnesses);

}  // namespace study

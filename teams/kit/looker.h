#pragma once

#include <array>
#include <span>

#include "sim/world/referee_message.h"
#include "sim/world/tracked_frame.h"
#include "teams/kit/ball_model.h"
#include "teams/kit/game_reader.h"
#include "teams/kit/team.h"

namespace kit {

/// Makes the `View` of each tick: turns the field when we defend +x, joins feedback and specs, and predicts
/// robots and ball to the moment when the answer takes effect.
///
/// The commands of reply n act from tick n + command latency on; what the cameras saw is older by the vision
/// delay. Our own robots are carried forward with the commands they were sent, under their limits; everything
/// else with its present velocity.
class Looker {
 public:
  explicit Looker(const Setup& setup);

  /// @param contacts  numbers of our robots whose break beam is interrupted
  const View& look(std::int64_t tick, const world::TrackedFrame& frame, const world::RefereeMessage& message,
                   std::span<const std::uint8_t> contacts);

  /// Remembers what was answered to the tick looked at last.
  void sent(const world::TeamCommands& commands);

  const View& view() const { return view_; }

 private:
  struct Sent {  // one robot's velocities in one reply
    Vector2d velocity_local = Vector2d::Zero();
    double angular_velocity = 0;
  };
  static constexpr std::size_t history = 8;  // replies kept: the longest delay known is 3 ticks ("harsh")

  void predict_own(Robot& robot, world::Time from) const;
  Vector2d steadied(const Vector2d& velocity);
  void watch_ball_speed(const world::TrackedFrame& frame);

  Setup setup_;
  BallModel model_;
  GameReader reader_;
  View view_;
  std::array<std::array<Sent, world::max_robot_number + 1>, history> sent_{};
  double rolls_below_ = 0;
  double speed_before_ = 0;
  double ball_direction_ = 0;  // [rad] field frame
  bool was_flipped_ = false;
};

}  // namespace kit

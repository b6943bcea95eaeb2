#pragma once

#include "sim/world/referee_message.h"
#include "teams/kit/view.h"

namespace kit {

/// Turns the referee's messages into `Game`, and notices what the referee does not say:
/// that the ball is in play, and that the kicker may touch it again. A kick that was only
/// a false detection is taken back when the ball is seen where it lay. The referee helps:
/// it counts down the time to the kick as long as it waits for one.
class GameReader {
 public:
  GameReader(world::Team team, double ball_radius) : team_(team), ball_radius_(ball_radius) {}

  /// True when `team` defends the goal at +x in this message.
  static bool defends_positive(const world::RefereeMessage& message, world::Team team) {
    return (team == world::Team::Blue) == message.blue_on_positive_half;
  }

  /// Reads one message; `view` has ball and robots of this tick already, in the own frame.
  void update(const world::RefereeMessage& message, const View& view, Game& game);

 private:
  void begin(const world::RefereeMessage& message, const View& view, Game& game);
  void watch_the_kick(const View& view, Game& game);
  void watch_for_no_kick(const View& view, Game& game);
  void in_play(const View& view, Game& game);
  void watch_for_another_touch(const View& view, Game& game);

  world::Team team_;
  double ball_radius_;
  std::optional<std::uint32_t> counter_;
  std::optional<world::Command> last_command_;
  int moved_frames_ = 0;
  Phase waited_in_ = Phase::Halt;  // before the ball was thought to be in play
  bool was_ours_ = false;
  bool told_to_wait_ = false;  // the referee counted the time to this kick
  double in_play_since_ = 0;   // [s]
  int still_frames_ = 0;
  Vector2d ball_velocity_before_ = Vector2d::Zero();
};

}  // namespace kit

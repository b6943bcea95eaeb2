#include "autoref/detectors/dribbled_too_far.h"

#include "autoref/detectors/ball.h"

namespace detectors {
namespace {

constexpr int frames_of_separation = 10;
constexpr double hidden_at = 0.03;  // [m] hull to the ball

}  // namespace

Events DribbledTooFar::update(const world::TrackedFrame& frame, const world::GameState&) {
  if (!frame.ball) return {};
  Events events;
  const world::Vector2d ball = on_ground(*frame.ball);
  const bool seen = frame.ball->observed;

  for (const world::TrackedRobot& robot : frame.robots) {
    if (robot.id.number > world::max_robot_number) continue;
    std::optional<Dribble>& dribble = dribbles_[robot.id.team][robot.id.number];
    if (!dribble) {
      if (robot.ball_in_reach) dribble = Dribble{ball, {frame.time, -max_distance_}};
      continue;
    }
    const bool hidden = !seen && gap_to_ball(field_, robot, ball) < hidden_at;
    if (!robot.ball_in_reach && !hidden) {
      if (++dribble->frames_apart > frames_of_separation) dribble.reset();
      continue;
    }
    const world::GuardSample now{frame.time, (ball - dribble->start).norm() - max_distance_};
    if (const auto time = rising_zero(dribble->guard, now)) dribble->passed = time;
    if (dribble->passed && seen && robot.ball_in_reach) {
      events.push_back({*dribble->passed, world::BotDribbledBallTooFar{robot.id, dribble->start, ball}});
      dribble->passed.reset();
    }
    dribble->guard = now;
    dribble->frames_apart = 0;
  }
  return events;
}

}  // namespace detectors

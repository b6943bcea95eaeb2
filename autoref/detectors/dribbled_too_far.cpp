#include "autoref/detectors/dribbled_too_far.h"

#include <algorithm>

#include "autoref/detectors/ball.h"

namespace detectors {
namespace {

constexpr int frames_of_separation = 10;
constexpr double hidden_at = 0.03;  // [m] hull to the ball
constexpr double taken_at = 0.05;   // [m] the same, of a robot that may have taken a hidden ball

}  // namespace

bool DribbledTooFar::another_near(const world::TrackedFrame& frame, world::RobotId robot,
                                  const world::Vector2d& ball) const {
  return std::ranges::any_of(frame.robots, [&](const world::TrackedRobot& other) {
    return other.id != robot && gap_to_ball(field_, other, ball) < taken_at;
  });
}

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
    if (!seen && !dribble->doubtful) dribble->doubtful = another_near(frame, robot.id, ball);
    if (seen && robot.ball_in_reach) dribble->doubtful = false;
    if (dribble->passed && robot.ball_in_reach && !dribble->doubtful) {
      events.push_back({*dribble->passed, world::BotDribbledBallTooFar{robot.id, dribble->start, ball}});
      dribble->passed.reset();
    }
    dribble->guard = now;
    dribble->frames_apart = 0;
  }
  return events;
}

}  // namespace detectors

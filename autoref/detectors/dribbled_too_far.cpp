#include "autoref/detectors/dribbled_too_far.h"

#include <algorithm>

#include "autoref/detectors/ball.h"

namespace detectors {
namespace {

// Hull to the ball [m].
constexpr double contact = 0.02;
constexpr double separate = 0.03;
constexpr int frames_of_separation = 2;
constexpr double taken_at = 0.05;  // of a robot that may have taken a hidden ball

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
    const double gap = gap_to_ball(field_, robot, ball);
    if (!dribble) {
      if (gap < (seen ? contact : separate) && !frame.ball->flight)
        dribble = Dribble{ball, {frame.time, -max_distance_}};
      continue;
    }
    if (gap > separate) {
      // Where a hidden ball is nobody knows so well.
      if (!seen) {
        dribble->doubtful = true;
      } else if (++dribble->frames_apart >= frames_of_separation) {
        dribble.reset();
      }
      continue;
    }
    const world::GuardSample now{frame.time, (ball - dribble->start).norm() - max_distance_};
    if (const auto time = rising_zero(dribble->guard, now)) dribble->passed = time;
    if (seen) {
      dribble->doubtful = false;
    } else if (!dribble->doubtful) {
      dribble->doubtful = another_near(frame, robot.id, ball);
    }
    if (dribble->passed && !dribble->doubtful) {
      events.push_back({*dribble->passed, world::BotDribbledBallTooFar{robot.id, dribble->start, ball}});
      dribble->passed.reset();
    }
    dribble->guard = now;
    dribble->frames_apart = 0;
  }
  return events;
}

}  // namespace detectors

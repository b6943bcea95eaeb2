#include "autoref/detectors/dribbled_too_far.h"

#include "autoref/detectors/ball.h"

namespace detectors {
namespace {

constexpr int frames_of_separation = 10;

}  // namespace

Events DribbledTooFar::update(const world::TrackedFrame& frame, const world::GameState&) {
  if (!frame.ball) return {};
  Events events;
  const world::Vector2d ball = on_ground(*frame.ball);

  for (const world::TrackedRobot& robot : frame.robots) {
    if (robot.id.number > world::max_robot_number) continue;
    std::optional<Dribble>& dribble = dribbles_[robot.id.team][robot.id.number];
    if (!robot.ball_in_reach) {
      if (dribble && ++dribble->frames_apart > frames_of_separation) dribble.reset();
      continue;
    }
    if (!dribble) {
      dribble = Dribble{ball, {frame.time, -max_distance_}};
      continue;
    }
    const world::GuardSample now{frame.time, (ball - dribble->start).norm() - max_distance_};
    if (const auto time = rising_zero(dribble->guard, now)) {
      events.push_back({*time, world::BotDribbledBallTooFar{robot.id, dribble->start, ball}});
    }
    dribble->guard = now;
    dribble->frames_apart = 0;
  }
  return events;
}

}  // namespace detectors

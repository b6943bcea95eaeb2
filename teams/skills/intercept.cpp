#include "teams/skills/intercept.h"

#include <algorithm>
#include <cmath>

namespace skills {

Meeting meet(const kit::View& view, const kit::Robot& robot, const Limits& limits,
             const kit::BallModel& model, double reach, double reserve) {
  const kit::Ball& ball = view.ball;
  const double speed = ball.velocity.norm();
  if (speed < 0.1) {  // [m/s] lies still, for any practical purpose
    return {ball.position, travel_time(ball.position - robot.position, robot.velocity, limits), false};
  }
  const Vector2d along = ball.velocity / speed;
  const auto place = [&](double time) -> Vector2d {
    return ball.position + along * model.distance_after(speed, ball.rolls_below, time);
  };
  // The centre of the robot stands behind the ball's way, facing the ball.
  const auto lateness = [&](double time) {
    const Vector2d to = place(time) + along * reach - robot.position;
    return travel_time(to, robot.velocity, limits) + reserve - time;
  };
  constexpr int samples = 8;
  constexpr double horizon = 2.5;
  const world::Field& field = view.field();
  double before = 0;
  double late_before = lateness(0);
  if (late_before <= 0) return {ball.position, 0, true};
  for (int i = 1; i <= samples; ++i) {
    const double now = horizon * i / samples;
    const Vector2d spot = place(now);
    if (world::distance_outside_lines(field, spot) > 0.2) {
      const Vector2d edge = place(before);
      return {edge, travel_time(edge - robot.position, robot.velocity, limits), false};
    }
    const double late = lateness(now);
    if (late <= 0) {
      double low = before, high = now, late_low = late_before, late_high = late;
      for (int k = 0; k < 3; ++k) {
        const double mid = low + (high - low) * late_low / (late_low - late_high);
        const double late_mid = lateness(mid);
        if (late_mid > 0) {
          low = mid;
          late_low = late_mid;
        } else {
          high = mid;
          late_high = late_mid;
        }
      }
      return {place(high), high, true};
    }
    before = now;
    late_before = late;
  }
  const Vector2d rest = place(horizon);
  return {rest, travel_time(rest - robot.position, robot.velocity, limits), false};
}

}  // namespace skills

#include "teams/skills/intercept.h"

#include <algorithm>
#include <cmath>

#include "teams/kit/ball_course.h"

namespace skills {

Meeting meet(const kit::View& view, const kit::Robot& robot, const Limits& limits,
             const kit::BallModel& model, double reach, double reserve) {
  const kit::Ball& ball = view.ball;
  const double speed = ball.velocity.norm();
  const auto at_rest = [&](const Vector2d& place) {
    return Meeting{place, travel_time(place - robot.position, robot.velocity, limits), false};
  };
  if (speed < 0.1 && !ball.flies) return at_rest(ball.position);  // [m/s] it lies still, for any purpose

  const kit::BallCourse course(ball, model);
  // The centre of the robot stands behind the ball's way, facing the ball.
  const auto lateness = [&](double time) {
    const Vector2d to = course.position(time) + course.along() * reach - robot.position;
    return travel_time(to, robot.velocity, limits) + reserve - time;
  };
  const auto too_high = [&](double time) { return course.flies() && course.height(time) > highest_capture; };
  constexpr int samples = 8;
  constexpr double horizon = 2.5;
  const world::Field& field = view.field();
  double before = 0;
  double late_before = lateness(0);
  if (late_before <= 0 && !too_high(0)) return {ball.position, 0, true};
  // When it passes the robot: the chance to meet it there may be shorter than the samples are apart.
  double passing = 2 * horizon;
  const double ahead = course.along().dot(robot.position - ball.position) - reach;
  if (ahead > 0 && !course.flies()) passing = model.time_to_cover(speed, ball.rolls_below, ahead);
  for (int i = 1; i <= samples;) {
    const double regular = horizon * i / samples;
    const bool passes_first = passing > before && passing < regular;
    const double now = passes_first ? passing : regular;
    if (!passes_first) ++i;
    const Vector2d spot = course.position(now);
    if (world::distance_outside_lines(field, spot) > 0.2) return at_rest(course.position(before));
    const double late = lateness(now);
    if (late <= 0 && !too_high(now)) {
      double low = before, high = now, late_low = late_before, late_high = late;
      for (int k = 0; k < 3; ++k) {
        // In the air before: halves, since being early there does not help.
        const bool splits = late_low > 0 && !course.flies();
        const double mid =
            splits ? low + (high - low) * late_low / (late_low - late_high) : 0.5 * (low + high);
        const double late_mid = lateness(mid);
        if (late_mid > 0 || too_high(mid)) {
          low = mid;
          late_low = late_mid;
        } else {
          high = mid;
          late_high = late_mid;
        }
      }
      return {course.position(high), high, true};
    }
    before = now;
    late_before = late;
  }
  return at_rest(course.position(horizon));
}

}  // namespace skills

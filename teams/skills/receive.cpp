#include "teams/skills/receive.h"

#include <algorithm>
#include <cmath>

#include "teams/kit/ball_course.h"
#include "teams/skills/ball_handling.h"
#include "teams/skills/motion.h"

namespace skills {
namespace {

Vector2d left_of(const Vector2d& v) { return {-v.y(), v.x()}; }

constexpr double slow = 0.4;          // [m/s] such a ball is fetched
constexpr double on_its_line = 0.25;  // [m] beside it: wait there rather than running away along it

}  // namespace

std::optional<Meeting> arrival(const kit::View& view, const kit::Robot& robot, const kit::BallModel& model) {
  const kit::Ball& ball = view.ball;
  const double speed = ball.velocity.norm();
  if (speed < slow) return {};
  const double contact = reach_of(robot, view.field().ball_radius);
  const Vector2d along = ball.velocity / speed;
  const Vector2d from_ball = robot.position - ball.position;
  const double ahead = from_ball.dot(along);
  if (!ball.flies && ahead > 0 && std::abs(from_ball.dot(left_of(along))) < on_its_line) {
    const double way = std::max(ahead - contact, 0.0);
    const double time = model.time_to_cover(speed, ball.rolls_below, way);
    // A slow ball that needs long is gone to meet: others want it too.
    const bool soon = time < 0.4 || speed > 3.0;
    if (soon && std::isfinite(time)) return Meeting{ball.position + along * way, time, true};
  }
  const Meeting meeting = meet(view, robot, driving_limits(robot.specs), model, contact, 0.1);
  if (!meeting.before_it_stops) return {};
  return meeting;
}

Order receive(const kit::View& view, const kit::Robot& robot, const kit::BallModel& model) {
  const std::optional<Meeting> meeting = arrival(view, robot, model);
  if (!meeting) {
    Order order = capture(view, robot, model);
    order.why = "fetch";
    return order;
  }
  const Vector2d along = view.ball.velocity.normalized();
  Order order;
  order.why = "receive";
  order.dribble = true;
  order.heading = world::angle_of(-along);
  order.robot_margin = 0.0;
  order.target = meeting->position + along * reach_of(robot, view.field().ball_radius);
  return order;
}

double redirect_angle(const Vector2d& ball_velocity, double direction) {
  return std::abs(world::wrap_angle(world::angle_of(-ball_velocity) - direction));
}

Order redirect(const kit::View& view, const kit::Robot& robot, const Meeting& where, double direction,
               double kick_speed, double tolerance) {
  Order order;
  order.why = "one-touch";
  order.robot_margin = 0.0;
  const Vector2d across = left_of(world::direction(robot.orientation));
  order.heading = direction - std::clamp(robot.velocity.dot(across) / kick_speed, -0.1, 0.1);
  order.target = where.position - world::direction(direction) * reach_of(robot, view.field().ball_radius);
  const double error = std::abs(world::wrap_angle(robot.orientation - order.heading));
  // Armed for the last quarter of a second only: before, another robot may push the ball here.
  if (where.time < 0.25 && error < tolerance) order.kick_speed = kick_speed;
  return order;
}

}  // namespace skills

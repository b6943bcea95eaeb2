#include "teams/skills/receive.h"

#include <algorithm>
#include <cmath>

#include "teams/kit/ball_course.h"
#include "teams/skills/ball_handling.h"
#include "teams/skills/motion.h"

namespace skills {
namespace {

Vector2d left_of(const Vector2d& v) { return {-v.y(), v.x()}; }

constexpr double nearly = 0.15;       // [s] late
constexpr double slow = 0.4;          // [m/s] such a ball is fetched
constexpr double soon = 0.4;          // [s]
constexpr double on_its_line = 0.25;  // [m] beside it: wait there rather than running away along it

// The robot is beside the ball's line, the ball soon there: how far it goes on along
// the line before it rests.
struct Passing {
  double beside = 0;  // [m]
  Meeting meeting;
};

// The front's middle stands `front` from the robot's centre.
std::optional<Passing> passing(const kit::Ball& ball, const kit::Robot& robot, const kit::BallModel& model,
                               const Vector2d& along, const Vector2d& front) {
  if (ball.flies) return {};
  const Vector2d from_ball = robot.position + front - ball.position;
  const Limits limits = driving_limits(robot.specs);
  const double drift = robot.velocity.dot(along);
  const double gap = from_ball.dot(along);
  double way = gap + drift * std::abs(drift) / (2 * along_track_share * limits.brake);
  if (gap < -0.02) return {};
  if (way < 0) {  // they run into each other before it has stopped
    const double speed = ball.velocity.norm();
    way = std::max(gap, 0.0) * speed / (speed - drift);
  }
  const double time = model.time_to_cover(ball.velocity.norm(), ball.rolls_below, std::max(way, 0.0));
  if (!std::isfinite(time)) return {};
  return Passing{std::abs(from_ball.dot(left_of(along))),
                 {ball.position + along * std::max(way, 0.0), time, true}};
}

}  // namespace

std::optional<Meeting> arrival(const kit::View& view, const kit::Robot& robot, const kit::BallModel& model,
                               std::optional<double> facing) {
  const kit::Ball& ball = view.ball;
  const double speed = ball.velocity.norm();
  if (speed < slow) return {};
  const double contact = reach_of(robot, view.field().ball_radius);
  const Vector2d along = ball.velocity / speed;
  const Vector2d front = contact * (facing ? world::direction(*facing) : Vector2d(-along));
  const std::optional<Passing> beside = passing(ball, robot, model, along, front);
  // A slow ball that needs long is gone to meet: others want it too.
  if (beside && beside->beside < on_its_line && (beside->meeting.time < soon || speed > 3.0)) {
    return beside->meeting;
  }
  const Limits limits = driving_limits(robot.specs);
  const Meeting meeting = meet(view, robot, limits, model, contact, 0.1);
  if (meeting.before_it_stops) return meeting;
  // Nearly in time: a part of the front is enough, and the ball's way is not known to the centimetre.
  if (beside) {
    const Vector2d to = beside->meeting.position - front - robot.position;
    if (travel_time(to, robot.velocity, limits) < beside->meeting.time + nearly) return beside->meeting;
  }
  return {};
}

namespace {

// Onto the ball's line before anything else, once the ball is nearly there.
void get_onto_line(const kit::View& view, const kit::Robot& robot, const Meeting& meeting, Order& order) {
  const Vector2d to_target = order.target - robot.position;
  if (meeting.time > soon || to_target.norm() > on_its_line + 0.1) return;
  order.velocity = cross_track_velocity(to_target, robot.velocity, view.ball.velocity.normalized(),
                                        driving_limits(robot.specs));
}

}  // namespace

Order receive(const kit::View& view, const kit::Robot& robot, const kit::BallModel& model) {
  if (robot.ball_contact) {
    Order order = carry(robot, robot.orientation, 0);
    order.why = "received";
    order.robot_margin = 0;
    return order;
  }
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
  get_onto_line(view, robot, *meeting, order);
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
  get_onto_line(view, robot, where, order);
  // Armed for the last quarter of a second only: before, another robot may push the ball here.
  if (where.time < 0.25 && error < tolerance) order.kick_speed = kick_speed;
  return order;
}

}  // namespace skills

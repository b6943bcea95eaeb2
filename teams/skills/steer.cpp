#include "teams/skills/steer.h"

#include <algorithm>
#include <cmath>

#include "teams/skills/motion.h"

namespace skills {
namespace {

// [rad/s] of the dribbler's bar; 150 is what simulators use (reference "football", section 5).
constexpr double dribbler_speed = 150;

// Farther than that from the area by its depth alone (most are): the distance itself need not be known.
bool is_clear_of_area(const world::Field& field, world::Side side, const Vector2d& point, double distance) {
  const world::DefenseArea& area = field.defense_area;
  const bool round = area.shape == world::DefenseArea::Shape::QuarterCircles;
  const double from_line = field.half_length() - world::sign(side) * point.x();
  return from_line - (round ? area.radius : area.depth) > distance + 1e-9;
}

Vector2d moved_out(const world::Field& field, world::Side side, const Vector2d& point, double distance) {
  if (is_clear_of_area(field, side, point, distance)) return point;
  return world::moved_out_of_defense_area(field, side, point, distance);
}

}  // namespace

Vector2d without_collisions(const kit::View& view, const kit::Robot& robot, Vector2d velocity,
                            double margin) {
  for (const auto* robots : {&view.own, &view.opponents}) {
    for (const kit::Robot& other : *robots) {
      if (robots == &view.own && other.number == robot.number) continue;
      const Vector2d to = other.position - robot.position;
      if (to.squaredNorm() > 1.5) continue;
      const double distance = to.norm();
      if (distance > 1.2 || distance < 1e-6) continue;  // [m] nobody needs more to brake from 3 m/s
      const Vector2d n = to / distance;
      const double gap = distance - robot.specs.radius - other.specs.radius - margin;
      // Half of the brake: the other may come nearer at the same time.
      double allowed = gap > 0 ? std::sqrt(robot.specs.max_brake * gap) : std::max(4.0 * gap, -0.3);
      allowed += std::min(0.0, other.velocity.dot(n)) * 0.5 + std::max(0.0, other.velocity.dot(n)) * 0.8;
      allowed = std::max(allowed, -0.3);
      const double closing = velocity.dot(n);
      if (closing > allowed) velocity -= n * (closing - allowed);
    }
  }
  return velocity;
}

Vector2d outside_area(const kit::View& view, const kit::Robot& robot, world::Side side, Vector2d velocity,
                      double margin) {
  const world::Field& field = view.field();
  if (is_clear_of_area(field, side, robot.position, 0.8 + robot.specs.radius + margin)) return velocity;
  const double gap =
      world::distance_to_defense_area(field, side, robot.position) - robot.specs.radius - margin;
  if (gap > 0.8) return velocity;  // [m] braking from 3 m/s takes less
  Vector2d out = world::moved_out_of_defense_area(field, side, robot.position, 3.0) - robot.position;
  if (out.norm() < 1e-6) return velocity;
  out.normalize();
  // Inside: out with at least 0.3 m/s. Outside: no faster inwards than can be braked.
  const double allowed = gap > 0 ? std::sqrt(robot.specs.max_brake * gap) : -0.3;
  const double inwards = -velocity.dot(out);
  if (inwards > allowed) velocity += out * (inwards - allowed);
  return velocity;
}

Vector2d legal_target(const kit::View& view, const kit::Robot& robot, const Order& order) {
  const world::Field& field = view.field();
  const double beyond = 0.25;  // [m] a robot may leave the field this far; the walls are at 0.7
  Vector2d target = order.target;
  target.x() = std::clamp(target.x(), -field.half_length() - beyond, field.half_length() + beyond);
  target.y() = std::clamp(target.y(), -field.half_width() - beyond, field.half_width() + beyond);
  if (!order.enter_own_area) {
    target = moved_out(field, world::Side::Negative, target, robot.specs.radius + 0.05);
  }
  return moved_out(field, world::Side::Positive, target, robot.specs.radius + order.their_area + 0.03);
}

double turning(const kit::Robot& robot, double heading, double max_turn) {
  Limits limits = turning_limits(robot.specs);
  limits.speed = std::min(limits.speed, max_turn);
  const double error = world::wrap_angle(heading - robot.orientation);
  return Profile(error, robot.angular_velocity, limits).velocity(world::tick_length);
}

world::RobotCommand Steering::command(const kit::View& view, const kit::Robot& robot, const Order& order) {
  Limits limits = driving_limits(robot.specs);
  limits.speed = std::min(limits.speed, order.max_speed);
  Vector2d velocity = Vector2d::Zero();
  const std::size_t index = std::min<std::size_t>(robot.number, side_.size() - 1);
  int& side = side_[index];
  int& cell = cells_[index];
  if (order.velocity) {
    velocity = *order.velocity;
  } else {
    const Vector2d target = legal_target(view, robot, order);
    const Path path = find_path(robot.position, target, obstacles_for(view, robot, order), side);
    side = path.side;
    const Vector2d to_via = path.via - robot.position;
    const double distance = to_via.norm();
    // Beyond the corner the way goes on: no braking for the corner itself.
    const Vector2d straightened = distance > 1e-6 ? Vector2d(to_via * (path.length / distance)) : to_via;
    velocity = Drive(straightened, robot.velocity, limits, &cell).velocity(world::tick_length);
  }
  if (order.robot_margin >= 0) velocity = without_collisions(view, robot, velocity, order.robot_margin * 0.5);
  if (!order.enter_own_area) velocity = outside_area(view, robot, world::Side::Negative, velocity, 0.01);
  velocity = outside_area(view, robot, world::Side::Positive, velocity, order.their_area);
  const double speed = velocity.norm();
  if (speed > limits.speed) velocity *= limits.speed / speed;

  world::RobotCommand command;
  command.number = robot.number;
  command.angular_velocity = turning(robot, order.heading, order.max_turn);
  // The robot turns while it drives: the middle of the tick is the best single heading.
  const double heading = robot.orientation + 0.5 * command.angular_velocity * world::tick_length;
  command.velocity_local = world::rotated(velocity, -heading);
  command.kick_speed = order.kick_speed;
  command.kick_angle = order.kick_angle;
  command.dribbler_speed = order.dribble ? dribbler_speed * order.dribble_share : 0;
  return command;
}

}  // namespace skills

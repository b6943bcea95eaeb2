#include "autoref/tracker/robot_filter.h"

#include "sim/world/time.h"

namespace tracker {
namespace {

constexpr double acceleration = 3.0;  // [m/s^2] world::RobotSpecs
constexpr double brake = 6.0;         // [m/s^2] world::RobotSpecs
constexpr double turn_per_speed = 7;  // [rad/m] a robot's 20 rad/s against its 3 m/s (world::RobotSpecs)

}  // namespace

RobotFilter::RobotFilter(const Params& params)
    : q_(params.robot_noise * params.robot_noise * world::tick_length),
      q_turn_(params.turn_noise * params.turn_noise * world::tick_length),
      r_(params.robot_sigma * params.robot_sigma),
      r_heading_(params.heading_sigma * params.heading_sigma) {}

void RobotFilter::start(const Vector2d& position, std::optional<double> heading, const Vector2d& velocity,
                        double speed_sigma) {
  const double vv = speed_sigma * speed_sigma;
  x_ = {position.x(), velocity.x(), r_, 0, vv};
  y_ = {position.y(), velocity.y(), r_, 0, vv};
  const double turn_vv = vv * turn_per_speed * turn_per_speed;
  heading_ =
      heading ? Axis{world::wrap_angle(*heading), 0, r_heading_, 0, turn_vv} : Axis{0, 0, 10, 0, turn_vv};
}

void RobotFilter::predict(double dt) {
  x_.predict(dt, q_);
  y_.predict(dt, q_);
  heading_.predict(dt, q_turn_);
  heading_.x = world::wrap_angle(heading_.x);
}

void RobotFilter::drive(const Vector2d& wanted, double dt) {
  const Vector2d missing = wanted - velocity();
  const double limit = (missing.dot(velocity()) < 0 ? brake : acceleration) * dt;
  const double size = missing.norm();
  const Vector2d change = size <= limit ? missing : Vector2d(missing * (limit / size));
  x_.v += change.x();
  y_.v += change.y();
  x_.x += change.x() * (dt / 2);
  y_.x += change.y() * (dt / 2);
}

double RobotFilter::nis(const Vector2d& measured) const {
  const double dx = measured.x() - x_.x;
  const double dy = measured.y() - y_.x;
  return dx * dx / (x_.xx + r_) + dy * dy / (y_.xx + r_);
}

double RobotFilter::heading_nis(double measured) const {
  const double d = world::wrap_angle(measured - heading_.x);
  return d * d / (heading_.xx + r_heading_);
}

void RobotFilter::update(const Vector2d& measured, std::optional<double> heading) {
  x_.update(measured.x() - x_.x, r_);
  y_.update(measured.y() - y_.x, r_);
  if (heading) {
    heading_.update(world::wrap_angle(*heading - heading_.x), r_heading_);
    heading_.x = world::wrap_angle(heading_.x);
  }
}

void RobotFilter::collide(const Vector2d& measured, double speed_sigma) {
  x_ = {measured.x(), x_.v, r_, 0, speed_sigma * speed_sigma};
  y_ = {measured.y(), y_.v, r_, 0, speed_sigma * speed_sigma};
}

void RobotFilter::spin(double measured, double turn_sigma) {
  heading_ = {world::wrap_angle(measured), heading_.v, r_heading_, 0, turn_sigma * turn_sigma};
}

}  // namespace tracker

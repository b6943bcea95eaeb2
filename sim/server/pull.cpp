#include "sim/server/pull.h"

#include <algorithm>

#include "sim/world/time.h"

namespace server {
namespace {

constexpr double stiffness = 5;      // [1/s]
constexpr double fastest = 3;        // [m/s]
constexpr double strongest = 20;     // [m/s^2]
constexpr double turning = 8;        // [1/s]
constexpr double fastest_turn = 10;  // [rad/s]
constexpr double gravity = 9.81;     // [m/s^2]
constexpr double at_rest = 0.001;    // [m] above the resting height: on the ground

template <class Vector>
Vector limited(const Vector& vector, double length) {
  const double size = vector.norm();
  return size <= length ? vector : Vector(vector * (length / size));
}

template <class Vector>
Vector towards(const Vector& velocity, const Vector& way) {
  const Vector wanted = limited(Vector(way * stiffness), fastest);
  return velocity + limited(Vector(wanted - velocity), strongest * world::tick_length);
}

}  // namespace

truth::Ball pulled(truth::Ball ball, const world::Vector3d& target, double ball_radius) {
  const bool on_the_ground = target.z() <= ball_radius + at_rest;
  if (on_the_ground) {
    ball.velocity.head<2>() =
        towards<world::Vector2d>(ball.velocity.head<2>(), (target - ball.position).head<2>());
    ball.spin = rolling_spin(ball.velocity, ball_radius);
    return ball;
  }
  // Half of what gravity takes in the tick is given before it: then the mean velocity is the wanted one.
  const world::Vector3d lift(0, 0, gravity * world::tick_length / 2);
  ball.velocity = towards<world::Vector3d>(ball.velocity + lift, target - ball.position) + lift;
  ball.spin.setZero();
  return ball;
}

truth::Robot pulled(truth::Robot robot, const RobotPull& target) {
  robot.velocity = towards<world::Vector2d>(robot.velocity, target.position - robot.position);
  robot.angular_velocity = std::clamp(turning * world::wrap_angle(target.orientation - robot.orientation),
                                      -fastest_turn, fastest_turn);
  return robot;
}

world::Vector3d rolling_spin(const world::Vector3d& velocity, double ball_radius) {
  return {-velocity.y() / ball_radius, velocity.x() / ball_radius, 0};
}

}  // namespace server

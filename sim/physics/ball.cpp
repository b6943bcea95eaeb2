#include "sim/physics/ball.h"

#include <algorithm>
#include <cmath>

namespace physics {
namespace {

using world::Vector2d;

// Leaving the carpet by less than this is rounding and contact noise, not flight (ours).
constexpr double ground_height = 1e-4;  // [m]
constexpr double ground_speed = 0.02;   // [m/s]

// Velocity of the ball's lowest point over the carpet.
Vector2d slip(const truth::Ball& ball, double radius) {
  return {ball.velocity.x() - radius * ball.spin.y(), ball.velocity.y() + radius * ball.spin.x()};
}

// An impulse per mass `push` [m/s] on the lowest point; 5/2 is from the inertia of a solid sphere.
void push_at_ground(truth::Ball& ball, const Vector2d& push, double radius) {
  ball.velocity.head<2>() += push;
  ball.spin.x() += 2.5 * push.y() / radius;
  ball.spin.y() -= 2.5 * push.x() / radius;
}

void set_rolling(truth::Ball& ball, double radius) {
  ball.spin.x() = -ball.velocity.y() / radius;
  ball.spin.y() = ball.velocity.x() / radius;
}

}  // namespace

bool on_ground(const truth::Ball& ball, const BallParams& params) {
  return ball.position.z() < params.radius + ground_height && std::abs(ball.velocity.z()) < ground_speed;
}

void apply_ground_friction(truth::Ball& ball, double duration, const BallParams& params) {
  const double pivot = params.pivot_deceleration * duration;
  ball.spin.z() -= std::clamp(ball.spin.z(), -pivot, pivot);

  double left = duration;
  const Vector2d u = slip(ball, params.radius);
  const double u_norm = u.norm();
  if (u_norm > 0) {
    const double slide_time = u_norm / (3.5 * params.slide_deceleration);
    const double slide = std::min(slide_time, left);
    push_at_ground(ball, u * (-params.slide_deceleration * slide / u_norm), params.radius);
    left -= slide;
    if (left <= 0) return;
  }
  const double speed = ball.velocity.head<2>().norm();
  const double loss = params.roll_deceleration * left;
  if (speed <= loss) {
    ball.velocity.head<2>().setZero();
    ball.spin.head<2>().setZero();
    return;
  }
  ball.velocity.head<2>() *= (speed - loss) / speed;
  set_rolling(ball, params.radius);
}

void bounce(truth::Ball& ball, const BallParams& params) {
  const double depth = params.radius - ball.position.z();
  if (depth <= 0) return;
  ball.position.z() = params.radius;
  if (ball.velocity.z() >= 0) return;

  const double fall = -ball.velocity.z();
  const double impact = std::sqrt(std::max(fall * fall - 2 * gravity * depth, 0.0));
  const double since = (fall - impact) / gravity;

  const Vector2d u = slip(ball, params.radius);
  const double u_norm = u.norm();
  if (u_norm > 0) {
    const double limit = params.bounce_friction * (1 + params.restitution) * impact;
    push_at_ground(ball, u * (-std::min(limit, u_norm * 2 / 7) / u_norm), params.radius);
  }

  const double rise = params.restitution * impact;
  if (rise * rise < 2 * gravity * params.smallest_hop) {
    ball.velocity.z() = 0;
    return;
  }
  ball.velocity.z() = rise - gravity * since;
  ball.position.z() = params.radius + std::max(rise * since - gravity * since * since / 2, 0.0);
}

double rolling_distance(double speed, const BallParams& params) {
  const double rolling = speed * 5 / 7;
  return (speed * speed - rolling * rolling) / (2 * params.slide_deceleration) +
         rolling * rolling / (2 * params.roll_deceleration);
}

}  // namespace physics

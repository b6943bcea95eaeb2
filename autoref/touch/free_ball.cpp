#include "autoref/touch/free_ball.h"

#include <algorithm>
#include <cmath>

namespace touch {
namespace {

constexpr double gravity = 9.81;         // [m/s^2]
constexpr double hull_friction = 0.22;   // ER-Force (reference "football", section 5)
constexpr double hop_friction = 0.35;    // on the carpet; ER-Force
constexpr double hop_restitution = 0.5;  // published .47 to .57
constexpr double smallest_hop = 0.010;   // [m] TIGERs
constexpr double spin_share = 2.5;       // a solid sphere's spin changes so much more than its velocity
constexpr double till_it_rolls = 1 / (1 + spin_share);  // of the slip, the change of velocity

/// Friction at the carpet for so much change of velocity at most [m/s].
void rub(FreeBall& ball, double most) {
  const Vector2d slip = ball.velocity - ball.spin;
  const double size = slip.norm();
  if (size < 1e-9) return;
  const double change = std::min(most, till_it_rolls * size);
  ball.velocity -= slip / size * change;
  ball.spin += slip / size * (spin_share * change);
}

}  // namespace

Vector2d move(FreeBall& ball, double dt, const Carpet& carpet) {
  Vector2d way = Vector2d::Zero();
  for (int hop = 0; ball.hops() && dt > 0 && hop < 8; ++hop) {
    const double lands =
        (ball.climb + std::sqrt(ball.climb * ball.climb + 2 * gravity * ball.height)) / gravity;
    const double t = std::min(dt, lands);
    way += ball.velocity * t;
    dt -= t;
    if (t < lands) {
      ball.height += ball.climb * t - gravity / 2 * t * t;
      ball.climb -= gravity * t;
      return way;
    }
    const double impact = gravity * t - ball.climb;
    rub(ball, hop_friction * (1 + hop_restitution) * impact);
    ball.height = 0;
    ball.climb = hop_restitution * impact;
    if (ball.climb * ball.climb < 2 * gravity * smallest_hop) ball.climb = 0;
  }
  if (!(dt > 0)) return way;
  const double slip = (ball.velocity - ball.spin).norm();
  const double slides = std::min(dt, slip * till_it_rolls / carpet.slide);
  const Vector2d before = ball.velocity;
  rub(ball, carpet.slide * slides);
  way += (before + ball.velocity) / 2 * slides;
  dt -= slides;
  const double speed = ball.velocity.norm();
  if (!(dt > 0)) return way;
  if (!(speed > 0)) return way;
  const double rolls = std::min(dt, speed / carpet.roll);
  way += ball.velocity * (rolls * (1 - carpet.roll * rolls / (2 * speed)));
  ball.velocity *= 1 - carpet.roll * rolls / speed;
  ball.spin = ball.velocity;
  return way;
}

void bounce(FreeBall& ball, const Vector2d& normal, const Vector2d& surface, double restitution) {
  const Vector2d side(-normal.y(), normal.x());
  const Vector2d relative = ball.velocity - surface;
  const double push = -(1 + restitution) * relative.dot(normal);
  const double slip = relative.dot(side);
  const double sideways = std::min(hull_friction * push, till_it_rolls * std::abs(slip));
  const double downward = std::max(0.0, -ball.spin.dot(normal));
  const double upward = std::min(hull_friction * push, till_it_rolls * downward);
  ball.velocity += push * normal - std::copysign(sideways, slip) * side;
  ball.spin += spin_share * upward * normal;
  ball.climb += upward;
}

}  // namespace touch

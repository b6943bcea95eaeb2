#pragma once

#include "autoref/touch/views.h"

namespace touch {

/// A ball on the carpet or just above it, with the spin that decides how it slides and hops.
struct FreeBall {
  Vector2d velocity = Vector2d::Zero();  ///< [m/s]
  Vector2d spin = Vector2d::Zero();      ///< [m/s] the velocity with which it would roll without sliding
  double height = 0;                     ///< [m] above its resting place
  double climb = 0;                      ///< [m/s] upwards

  bool rolls() const { return !hops() && (velocity - spin).squaredNorm() < 1e-8; }
  bool hops() const { return height > 0 || climb > 0; }
};

/// The carpet, as the geometry message tells it.
struct Carpet {
  double slide = 3.0;  ///< [m/s^2]
  double roll = 0.26;  ///< [m/s^2]
};

/// Moves it for a while [s]; friction works against the slip until it rolls, hops end as in the league's ball
/// models: half of the speed is left, and below a centimetre it stays on the ground.
/// @return its way [m]
Vector2d move(FreeBall& ball, double dt, const Carpet& carpet);

/// A hull meets it: the part of the velocity along the normal is turned round, and friction
/// works on what slips, sideways and, since a rolling ball turns downwards where it meets a wall,
/// upwards too: the ball hops.
/// @param normal       from the hull to the ball, of length 1
/// @param surface      [m/s] velocity of the hull
/// @param restitution  [0, 1]
/// @pre it comes nearer
void bounce(FreeBall& ball, const Vector2d& normal, const Vector2d& surface, double restitution);

}  // namespace touch

#pragma once

#include <span>

#include "sim/world/geometry.h"

namespace touch {

using world::Vector2d;

// The tests of the paper's 6.5.2 on bare positions. Histories are newest first: index n is n frames ago. All
// lengths are in metres; a frame is 1/60 s.

/// Half the acceleration of the ball as `accel` measures it [m/s^2]: |p1 - (p0 + p2)/2| in units of a frame
/// squared. This is half the true acceleration (I-22).
/// @pre at least 3 positions
double accel_measure(std::span<const Vector2d> ball);

/// `line`: the last six positions relative to a robot are two straight pieces that meet within `reach`
/// [m] of its centre and are not one line.
/// @pre at least 6 positions
bool line_says_touch(std::span<const Vector2d> ball_from_robot, double reach);

/// `line` with the tests of the authors' code besides (I-23): the pieces meet at the inner tenth of both or
/// beyond it, and nearer to the robot than the outer ends of both are.
/// @pre at least 6 positions
bool line_says_touch_as_coded(std::span<const Vector2d> ball_from_robot, double reach);

/// `backtrack`: the last four positions lie on a straight course which comes out of the robot.
/// @param contact  [m] R + r: aborts when the course itself passes within it
/// @param inside   [m] R + r - 10 mm: one or two frames earlier the course was within it
/// @pre at least 4 positions
bool backtrack_says_touch(std::span<const Vector2d> ball_from_robot, double contact, double inside);

/// `backtrack` as in the authors' code (I-24): it aborts when the four positions before the last four pass
/// within `over` [m], R - r; those of the fit may be in contact.
/// @pre at least 8 positions
bool backtrack_says_touch_as_coded(std::span<const Vector2d> ball_from_robot, double over, double inside);

}  // namespace touch

#pragma once

#include <cstdint>

#include "sim/world/field.h"

namespace vision {

/// Pixel of a point [px], counted from the image's corner at -x and +y, to the right and down.
///
/// A pinhole that looks straight down, with the point at p - c from the camera's foot and at depth H - z:
///
///   u = w/2 + f (p_x - c_x) / (H - z)
///   v = h/2 - f (p_y - c_y) / (H - z)
///
/// It is the geometry message's formula for the quaternion (1, 0, 0, 0) (reference "protocol", 2.1).
///
/// @pre the point is below the camera
world::Vector2d pixel_of(const world::Camera& camera, const world::Vector3d& point);

/// Area of a ball's image [px], all of it in view.
///
/// The image of a sphere is an ellipse. With the distance d and the depth z of its centre:
///
///   area = pi f^2 r^2 sqrt(d^2 - r^2) / (z^2 - r^2)^(3/2)
///
/// Depths below a tenth of the camera's height count as a tenth of it (see `projected_to_ground`).
double ball_area(const world::Camera& camera, const world::Vector3d& ball, double ball_radius);

/// The confidence SSL-Vision gives a ball for its area [px], where 30 to 40 px are expected:
///
///   exp(-((area - expected) / 100)^2 / 2)
///
/// Source  SSL-Vision, ball detection with its default settings. It gives all 366 confidences of a league log
///         of 2022 to 3e-8.
double ball_confidence(std::uint32_t area);

/// The confidence of a robot pattern that fits: SSL-Vision's g / (g + 0.05) with a fit g of 1. A league log
/// of 2022 has 0.9509 to 0.9524.
inline constexpr double robot_confidence = 1 / 1.05;

/// Where the ball's centre appears on the ground: the ray from the camera through it, followed down.
///
/// For a camera at height H and a ball whose lowest point is at height z:
///
///   g = c + (p - c) H / (H - z)
///
/// Source: reference "football", 3.3; heights are counted from the resting ball, as the league's calibration
/// does. Heights above 0.9 H count as 0.9 H (ER-Force simulator does the same), so the result stays finite.
world::Vector2d projected_to_ground(const world::Vector3d& camera, const world::Vector3d& ball,
                                    double ball_radius);

/// The same formula for any point below the camera, also for one lower than a resting ball's centre.
world::Vector2d on_ball_plane(const world::Vector3d& camera, const world::Vector3d& point,
                              double ball_radius);

}  // namespace vision

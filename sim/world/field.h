#pragma once

#include <vector>

#include "sim/world/geometry.h"

namespace world {

/// The two shapes the laws have known: quarter circles joined by a straight piece (2015),
/// a rectangle (since 2018).
struct DefenseArea {
  enum class Shape { QuarterCircles, Rectangle };
  Shape shape = Shape::QuarterCircles;
  double radius = 1.0;   ///< [m] quarter circles
  double stretch = 0.5;  ///< [m] the straight piece between them
  double depth = 1.0;    ///< [m] rectangle, along x
  double width = 2.0;    ///< [m] rectangle, along y
};

/// Dimensions of the field, its goals, and what stands on it; lines are measured to their outer edge.
///
/// Source  laws of 2015, Law 1 (reference "protocol", 5.1).
struct Field {
  double length = 9.0;                 ///< [m] goal line to goal line, along x
  double width = 6.0;                  ///< [m] touch line to touch line, along y
  double boundary_width = 0.7;         ///< [m] run-off between the lines and the wall
  double goal_width = 1.0;             ///< [m] between the posts
  double goal_depth = 0.18;            ///< [m] goal line to the inside of the back wall
  double goal_height = 0.155;          ///< [m] underside of the crossbar
  double goal_wall = 0.02;             ///< [m] thickness of posts, sides and back
  double line_thickness = 0.01;        ///< [m]
  double center_circle_radius = 0.5;   ///< [m]
  double penalty_mark_distance = 1.0;  ///< [m] from the centre of the goal
  DefenseArea defense_area;
  double ball_radius = 0.0215;  ///< [m]
  double robot_radius = 0.09;   ///< [m]

  double half_length() const { return length / 2; }
  double half_width() const { return width / 2; }
};

/// A camera above the field, as the geometry message describes it.
struct Camera {
  int id = 0;
  Vector3d position = Vector3d::Zero();  ///< [m] field frame
  double focal_length = 800;             ///< [px] pinhole, looking straight down, no distortion
  int image_width = 1280;                ///< [px] along x; the principal point is the middle
  int image_height = 1024;               ///< [px] along y
};

/// What SSL-Vision's geometry message tells everyone.
struct Geometry {
  Field field;
  std::vector<Camera> cameras;
  double ball_slide_deceleration = 3.0;  ///< [m/s^2]
  double ball_roll_deceleration = 0.26;  ///< [m/s^2]
  double ball_switch_ratio = 5.0 / 7.0;  ///< rolling begins at this share of the kick speed
};

/// `count` cameras over the centres of equal parts of the field: 1, 2 (halves), 4 (quarters),
/// 6 or 8 (two rows). The paper has four (3.1), and 4 m is the usual height of SSL-Vision set-ups.
/// Their focal length is the default, or a smaller one, in whole pixels, where robots at the walls would
/// otherwise be outside the image.
///
/// @throws std::invalid_argument for another count or a height that is not positive
std::vector<Camera> camera_grid(const Field& field, int count, double height);

/// Four cameras above the centres of the quarters, 4 m high.
std::vector<Camera> quarter_cameras(const Field& field, double height = 4.0);

/// Which goal: the one at -x or the one at +x.
enum class Side { Negative, Positive };
constexpr double sign(Side side) { return side == Side::Positive ? 1.0 : -1.0; }
constexpr Side other(Side side) { return side == Side::Positive ? Side::Negative : Side::Positive; }

/// Centre of the goal on the goal line.
Vector2d goal_center(const Field& field, Side side);

/// Distance to the defense area of `side` [m], seen as an area that also extends behind the goal line;
/// negative inside.
double distance_to_defense_area(const Field& field, Side side, const Vector2d& point);

/// Nearest point that is at least `distance` [m] outside the defense area of `side`;
/// `point` itself when it already is.
Vector2d moved_out_of_defense_area(const Field& field, Side side, const Vector2d& point, double distance);

/// How far the point is outside the lines [m]; negative inside, measured to the nearest line.
double distance_outside_lines(const Field& field, const Vector2d& point);

}  // namespace world

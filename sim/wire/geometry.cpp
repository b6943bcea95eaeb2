#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <string_view>

#include "sim/wire/units.h"
#include "sim/wire/vision.h"

namespace wire {

namespace {

using Shape = world::DefenseArea::Shape;
using world::Vector2d;
using world::Vector3d;

constexpr double pi = std::numbers::pi;

// Where the middle of the paint lies inside the field's dimensions [m]: the laws of 2015 measure to the outer
// edge of the lines, the rules since the rectangle to their middle (reference "protocol", 5.1).
double paint_inset(const world::Field& field) {
  return field.defense_area.shape == Shape::QuarterCircles ? field.line_thickness / 2 : 0.0;
}

void set_point(const Vector2d& point, proto::Vector2f& out) {
  out.set_x(to_mm(point.x()));
  out.set_y(to_mm(point.y()));
}

/// Adds markings, all of one thickness.
class Painter {
 public:
  Painter(double thickness, proto::SSL_GeometryFieldSize& out) : thickness_(to_mm(thickness)), out_(out) {}

  void line(const char* name, proto::SSL_FieldShapeType type, const Vector2d& from, const Vector2d& to) {
    proto::SSL_FieldLineSegment& line = *out_.add_field_lines();
    line.set_name(name);
    set_point(from, *line.mutable_p1());
    set_point(to, *line.mutable_p2());
    line.set_thickness(thickness_);
    line.set_type(type);
  }
  proto::SSL_FieldCircularArc& arc(const char* name, const Vector2d& center, double radius, double from,
                                   double to) {
    proto::SSL_FieldCircularArc& arc = *out_.add_field_arcs();
    arc.set_name(name);
    set_point(center, *arc.mutable_center());
    arc.set_radius(to_mm(radius));
    arc.set_a1(static_cast<float>(from));
    arc.set_a2(static_cast<float>(to));
    arc.set_thickness(thickness_);
    return arc;
  }

 private:
  float thickness_;  // [mm]
  proto::SSL_GeometryFieldSize& out_;
};

// Names and angles of SSL-Vision in 2015 (reference "protocol", 5.4).
void paint_quarter_circles(const world::Field& field, Painter& painter) {
  const world::DefenseArea& area = field.defense_area;
  const double goal_line = field.half_length();
  const double y = area.stretch / 2;
  const double radius = area.radius - paint_inset(field);
  const double x = goal_line - radius;
  painter.line("LeftPenaltyStretch", proto::LeftPenaltyStretch, {-x, -y}, {-x, y});
  painter.line("RightPenaltyStretch", proto::RightPenaltyStretch, {x, -y}, {x, y});
  painter.arc("LeftFieldLeftPenaltyArc", {-goal_line, y}, radius, 0, pi / 2);
  painter.arc("LeftFieldRightPenaltyArc", {-goal_line, -y}, radius, 1.5 * pi, 2 * pi);
  painter.arc("RightFieldLeftPenaltyArc", {goal_line, -y}, radius, pi, 1.5 * pi);
  painter.arc("RightFieldRightPenaltyArc", {goal_line, y}, radius, pi / 2, pi);
}

void paint_rectangles(const world::Field& field, Painter& painter) {
  const world::DefenseArea& area = field.defense_area;
  const double goal_line = field.half_length();
  const double x = goal_line - area.depth;
  const double y = area.width / 2;
  painter.line("LeftPenaltyStretch", proto::LeftPenaltyStretch, {-x, -y}, {-x, y});
  painter.line("RightPenaltyStretch", proto::RightPenaltyStretch, {x, -y}, {x, y});
  painter.line("LeftFieldLeftPenaltyStretch", proto::LeftFieldLeftPenaltyStretch, {-goal_line, -y}, {-x, -y});
  painter.line("LeftFieldRightPenaltyStretch", proto::LeftFieldRightPenaltyStretch, {-goal_line, y}, {-x, y});
  painter.line("RightFieldRightPenaltyStretch", proto::RightFieldRightPenaltyStretch, {goal_line, -y},
               {x, -y});
  painter.line("RightFieldLeftPenaltyStretch", proto::RightFieldLeftPenaltyStretch, {goal_line, y}, {x, y});
}

void encode_field(const world::Field& field, proto::SSL_GeometryFieldSize& out) {
  const world::DefenseArea& area = field.defense_area;
  const double inset = paint_inset(field);
  out.set_field_length(to_whole_mm(field.length));
  out.set_field_width(to_whole_mm(field.width));
  out.set_goal_width(to_whole_mm(field.goal_width));
  out.set_goal_depth(to_whole_mm(field.goal_depth));
  out.set_boundary_width(to_whole_mm(field.boundary_width));
  out.set_center_circle_radius(to_whole_mm(field.center_circle_radius - inset));
  out.set_line_thickness(to_whole_mm(field.line_thickness));
  out.set_goal_center_to_penalty_mark(to_whole_mm(field.penalty_mark_distance));
  out.set_goal_height(to_whole_mm(field.goal_height));
  out.set_ball_radius(to_mm(field.ball_radius));
  out.set_max_robot_radius(to_mm(field.robot_radius));

  Painter painter(field.line_thickness, out);
  const double x = field.half_length() - inset;
  const double y = field.half_width() - inset;
  painter.line("TopTouchLine", proto::TopTouchLine, {-x, y}, {x, y});
  painter.line("BottomTouchLine", proto::BottomTouchLine, {-x, -y}, {x, -y});
  painter.line("LeftGoalLine", proto::LeftGoalLine, {-x, -y}, {-x, y});
  painter.line("RightGoalLine", proto::RightGoalLine, {x, -y}, {x, y});
  painter.line("HalfwayLine", proto::HalfwayLine, {0, -y}, {0, y});
  painter.line("CenterLine", proto::CenterLine, {-x, 0}, {x, 0});
  painter.arc("CenterCircle", {0, 0}, field.center_circle_radius - inset, 0, 2 * pi)
      .set_type(proto::CenterCircle);
  if (area.shape == Shape::QuarterCircles) {
    paint_quarter_circles(field, painter);
  } else {
    out.set_penalty_area_depth(to_whole_mm(area.depth));
    out.set_penalty_area_width(to_whole_mm(area.width));
    paint_rectangles(field, painter);
  }
}

// Looking straight down: half a turn about x, so that t = -R C; a pinhole whose principal point is the middle
// of the image (reference "protocol", 2.1).
void encode_camera(const world::Camera& camera, proto::SSL_GeometryCameraCalibration& out) {
  const Vector3d& c = camera.position;
  out.set_camera_id(static_cast<std::uint32_t>(camera.id));
  out.set_focal_length(static_cast<float>(camera.focal_length));
  out.set_principal_point_x(static_cast<float>(camera.image_width) / 2);
  out.set_principal_point_y(static_cast<float>(camera.image_height) / 2);
  out.set_distortion(0);
  out.set_q0(1);
  out.set_q1(0);
  out.set_q2(0);
  out.set_q3(0);
  out.set_tx(to_mm(-c.x()));
  out.set_ty(to_mm(c.y()));
  out.set_tz(to_mm(c.z()));
  out.set_derived_camera_world_tx(to_mm(c.x()));
  out.set_derived_camera_world_ty(to_mm(c.y()));
  out.set_derived_camera_world_tz(to_mm(c.z()));
  out.set_pixel_image_width(static_cast<std::uint32_t>(camera.image_width));
  out.set_pixel_image_height(static_cast<std::uint32_t>(camera.image_height));
}

// Optics that make sense replace the defaults: 1 to 100 000 px.
void decode_optics(const proto::SSL_GeometryCameraCalibration& calibration, world::Camera& camera) {
  constexpr float largest = 100'000;
  const auto take_pixels = [](std::uint32_t pixels, int& out) {
    if (pixels >= 1 && pixels <= static_cast<std::uint32_t>(largest)) out = static_cast<int>(pixels);
  };
  const float focal_length = calibration.focal_length();
  if (focal_length >= 1 && focal_length <= largest) camera.focal_length = static_cast<double>(focal_length);
  take_pixels(calibration.pixel_image_width(), camera.image_width);
  take_pixels(calibration.pixel_image_height(), camera.image_height);
}

std::optional<world::Camera> decode_camera(const proto::SSL_GeometryCameraCalibration& calibration) {
  if (!calibration.has_camera_id() || calibration.camera_id() > 255) return std::nullopt;
  Vector3d position;
  if (calibration.has_derived_camera_world_tx() && calibration.has_derived_camera_world_ty() &&
      calibration.has_derived_camera_world_tz()) {
    position = {from_mm(calibration.derived_camera_world_tx()),
                from_mm(calibration.derived_camera_world_ty()),
                from_mm(calibration.derived_camera_world_tz())};
  } else {
    const Eigen::Quaterniond to_camera(calibration.q3(), calibration.q0(), calibration.q1(),
                                       calibration.q2());
    const Vector3d t(from_mm(calibration.tx()), from_mm(calibration.ty()), from_mm(calibration.tz()));
    position = -(to_camera.normalized().conjugate() * t);
  }
  if (!(position.cwiseAbs().maxCoeff() <= from_mm(max_coordinate_mm)) || !position.allFinite())
    return std::nullopt;
  world::Camera camera{static_cast<int>(calibration.camera_id()), position};
  decode_optics(calibration, camera);
  return camera;
}

template <class Marking>
const Marking* find(const google::protobuf::RepeatedPtrField<Marking>& markings, std::string_view name,
                    proto::SSL_FieldShapeType type) {
  for (const Marking& marking : markings) {
    if (marking.name() == name || (marking.has_type() && marking.type() == type)) return &marking;
  }
  return nullptr;
}

double extent(const proto::SSL_FieldLineSegment& line) {
  return std::hypot(from_mm(line.p2().x()) - from_mm(line.p1().x()),
                    from_mm(line.p2().y()) - from_mm(line.p1().y()));
}

/// A length that makes sense, 0 to 100 m, replaces the default.
void take(double metres, double& length) {
  if (metres > 0 && metres <= from_mm(max_coordinate_mm)) length = metres;
}

const proto::SSL_FieldCircularArc* find_penalty_arc(const proto::SSL_GeometryFieldSize& field) {
  for (const proto::SSL_FieldCircularArc& arc : field.field_arcs()) {
    if (arc.name().find("PenaltyArc") != std::string::npos) return &arc;
  }
  return nullptr;
}

void decode_defense_area(const proto::SSL_GeometryFieldSize& size, world::Field& field) {
  world::DefenseArea& area = field.defense_area;
  const auto& lines = size.field_lines();
  const proto::SSL_FieldLineSegment* stretch = find(lines, "LeftPenaltyStretch", proto::LeftPenaltyStretch);
  const proto::SSL_FieldLineSegment* side =
      find(lines, "LeftFieldLeftPenaltyStretch", proto::LeftFieldLeftPenaltyStretch);
  if (size.has_penalty_area_depth() && size.has_penalty_area_width()) {
    area.shape = Shape::Rectangle;
    take(from_whole_mm(size.penalty_area_depth()), area.depth);
    take(from_whole_mm(size.penalty_area_width()), area.width);
  } else if (const proto::SSL_FieldCircularArc* arc = find_penalty_arc(size)) {
    area.shape = Shape::QuarterCircles;
    take(from_mm(arc->radius()) + field.line_thickness / 2, area.radius);
    if (stretch) take(extent(*stretch), area.stretch);
  } else if (stretch && side) {
    area.shape = Shape::Rectangle;
    take(extent(*side), area.depth);
    take(extent(*stretch), area.width);
  }
}

constexpr std::int32_t least_size_mm = 500;  // ours: less is no room for a robot
constexpr std::size_t max_cameras = 64;      // ours: the league had 4 to 8

bool size_makes_sense(std::int32_t length, std::int32_t width) {
  return length >= least_size_mm && width >= least_size_mm && is_coordinate(static_cast<float>(length)) &&
         is_coordinate(static_cast<float>(width));
}

world::Field decode_field(const proto::SSL_GeometryFieldSize& size) {
  world::Field field;
  field.length = from_whole_mm(size.field_length());
  field.width = from_whole_mm(size.field_width());
  take(from_whole_mm(size.goal_width()), field.goal_width);
  take(from_whole_mm(size.goal_depth()), field.goal_depth);
  take(from_whole_mm(size.boundary_width()), field.boundary_width);
  if (size.has_line_thickness()) {
    take(from_whole_mm(size.line_thickness()), field.line_thickness);
  } else if (!size.field_lines().empty()) {
    take(from_mm(size.field_lines(0).thickness()), field.line_thickness);
  }
  decode_defense_area(size, field);
  if (const proto::SSL_FieldCircularArc* arc = find(size.field_arcs(), "CenterCircle", proto::CenterCircle)) {
    take(from_mm(arc->radius()) + paint_inset(field), field.center_circle_radius);
  } else if (size.has_center_circle_radius()) {
    take(from_whole_mm(size.center_circle_radius()) + paint_inset(field), field.center_circle_radius);
  }
  take(from_whole_mm(size.goal_center_to_penalty_mark()), field.penalty_mark_distance);
  take(from_whole_mm(size.goal_height()), field.goal_height);
  take(from_mm(size.ball_radius()), field.ball_radius);
  take(from_mm(size.max_robot_radius()), field.robot_radius);
  return field;
}

void decode_ball_model(const proto::SSL_BallModelStraightTwoPhase& model, world::Geometry& out) {
  const double slide = -model.acc_slide();
  const double roll = -model.acc_roll();
  const bool makes_sense = slide > 0 && std::isfinite(slide) && roll > 0 && std::isfinite(roll) &&
                           model.k_switch() > 0 && model.k_switch() <= 1;
  if (!makes_sense) return;
  out.ball_slide_deceleration = slide;
  out.ball_roll_deceleration = roll;
  out.ball_switch_ratio = model.k_switch();
}

template <class Calibrations>
std::vector<world::Camera> decode_cameras(const Calibrations& calibrations) {
  std::vector<world::Camera> cameras;
  for (const proto::SSL_GeometryCameraCalibration& calibration : calibrations) {
    if (cameras.size() == max_cameras) break;
    if (const std::optional<world::Camera> camera = decode_camera(calibration)) cameras.push_back(*camera);
  }
  return cameras;
}

}  // namespace

void encode(const world::Geometry& geometry, proto::SSL_GeometryData& out) {
  out.Clear();
  encode_field(geometry.field, *out.mutable_field());
  for (const world::Camera& camera : geometry.cameras) encode_camera(camera, *out.add_calib());
  proto::SSL_BallModelStraightTwoPhase& ball = *out.mutable_models()->mutable_straight_two_phase();
  ball.set_acc_slide(-geometry.ball_slide_deceleration);
  ball.set_acc_roll(-geometry.ball_roll_deceleration);
  ball.set_k_switch(geometry.ball_switch_ratio);
}

std::optional<world::Geometry> decode(const proto::SSL_GeometryData& geometry) {
  if (!size_makes_sense(geometry.field().field_length(), geometry.field().field_width())) return std::nullopt;
  world::Geometry result;
  result.field = decode_field(geometry.field());
  result.cameras = decode_cameras(geometry.calib());
  if (geometry.models().has_straight_two_phase()) {
    decode_ball_model(geometry.models().straight_two_phase(), result);
  }
  return result;
}

std::optional<world::Geometry> decode(const matchday::legacy2014::SSL_GeometryData& geometry) {
  const matchday::legacy2014::SSL_GeometryFieldSize& size = geometry.field();
  if (!size_makes_sense(size.field_length(), size.field_width())) return std::nullopt;
  world::Geometry result;
  world::Field& field = result.field;
  field.length = from_whole_mm(size.field_length());
  field.width = from_whole_mm(size.field_width());
  take(from_whole_mm(size.line_width()), field.line_thickness);
  take(from_whole_mm(size.boundary_width()), field.boundary_width);
  take(from_whole_mm(size.goal_width()), field.goal_width);
  take(from_whole_mm(size.goal_depth()), field.goal_depth);
  take(from_whole_mm(size.goal_wall_width()), field.goal_wall);
  take(from_whole_mm(size.center_circle_radius()), field.center_circle_radius);
  field.defense_area.shape = Shape::QuarterCircles;
  take(from_whole_mm(size.defense_radius()), field.defense_area.radius);
  take(from_whole_mm(size.defense_stretch()), field.defense_area.stretch);
  take(from_whole_mm(size.penalty_spot_from_field_line_dist()), field.penalty_mark_distance);
  result.cameras = decode_cameras(geometry.calib());
  return result;
}

}  // namespace wire

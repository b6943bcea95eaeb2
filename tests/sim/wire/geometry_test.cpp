#include <gmock/gmock.h>
#include <google/protobuf/text_format.h>

#include <numbers>

#include "sim/wire/vision.h"
#include "sim/world/rules/ssl_2015.h"
#include "tests/sim/wire/league_schema.h"

namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;
using Shape = world::DefenseArea::Shape;

world::Geometry division_a() {
  world::Geometry geometry;
  geometry.field.length = 12;
  geometry.field.width = 9;
  geometry.field.goal_width = 1.8;
  geometry.field.boundary_width = 0.3;
  geometry.field.penalty_mark_distance = 8;
  geometry.field.defense_area = {.shape = Shape::Rectangle, .depth = 1.8, .width = 3.6};
  geometry.cameras = world::quarter_cameras(geometry.field);
  geometry.cameras[2].focal_length = 1449.25;  // a float
  geometry.cameras[2].image_width = 2448;
  geometry.cameras[2].image_height = 2048;
  return geometry;
}

world::Geometry year_2015() {
  world::Geometry geometry;
  geometry.cameras = world::quarter_cameras(geometry.field);
  return geometry;
}

wire::proto::SSL_GeometryData encoded(const world::Geometry& geometry) {
  wire::proto::SSL_GeometryData message;
  wire::encode(geometry, message);
  return message;
}

// All dimensions are whole millimetres, which 12 digits of a double tell apart from anything else.
constexpr double exact = 1e-12;

void expect_same(const world::Geometry& a, const world::Geometry& b) {
  EXPECT_NEAR(a.field.length, b.field.length, exact);
  EXPECT_NEAR(a.field.width, b.field.width, exact);
  EXPECT_NEAR(a.field.boundary_width, b.field.boundary_width, exact);
  EXPECT_NEAR(a.field.goal_width, b.field.goal_width, exact);
  EXPECT_NEAR(a.field.goal_depth, b.field.goal_depth, exact);
  EXPECT_NEAR(a.field.goal_height, b.field.goal_height, exact);
  EXPECT_NEAR(a.field.line_thickness, b.field.line_thickness, exact);
  EXPECT_NEAR(a.field.center_circle_radius, b.field.center_circle_radius, exact);
  EXPECT_NEAR(a.field.penalty_mark_distance, b.field.penalty_mark_distance, exact);
  EXPECT_NEAR(a.field.ball_radius, b.field.ball_radius, exact);
  EXPECT_NEAR(a.field.robot_radius, b.field.robot_radius, exact);
  EXPECT_EQ(a.field.defense_area.shape, b.field.defense_area.shape);
  EXPECT_NEAR(a.field.defense_area.radius, b.field.defense_area.radius, exact);
  EXPECT_NEAR(a.field.defense_area.stretch, b.field.defense_area.stretch, exact);
  EXPECT_NEAR(a.field.defense_area.depth, b.field.defense_area.depth, exact);
  EXPECT_NEAR(a.field.defense_area.width, b.field.defense_area.width, exact);
  ASSERT_EQ(a.cameras.size(), b.cameras.size());
  for (std::size_t i = 0; i < a.cameras.size(); ++i) {
    EXPECT_EQ(a.cameras[i].id, b.cameras[i].id);
    EXPECT_LT((a.cameras[i].position - b.cameras[i].position).norm(), exact);
    EXPECT_EQ(a.cameras[i].focal_length, b.cameras[i].focal_length);
    EXPECT_EQ(a.cameras[i].image_width, b.cameras[i].image_width);
    EXPECT_EQ(a.cameras[i].image_height, b.cameras[i].image_height);
  }
  EXPECT_EQ(a.ball_slide_deceleration, b.ball_slide_deceleration);
  EXPECT_EQ(a.ball_roll_deceleration, b.ball_roll_deceleration);
  EXPECT_EQ(a.ball_switch_ratio, b.ball_switch_ratio);
}

std::vector<std::string> arc_names(const wire::proto::SSL_GeometryData& message) {
  std::vector<std::string> names;
  for (const auto& arc : message.field().field_arcs()) names.push_back(arc.name());
  return names;
}

std::vector<std::string> line_names(const wire::proto::SSL_GeometryData& message) {
  std::vector<std::string> names;
  for (const auto& line : message.field().field_lines()) names.push_back(line.name());
  return names;
}

wire::proto::SSL_GeometryData parse(const std::string& text) {
  wire::proto::SSL_GeometryData message;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(text, &message));
  return message;
}

const std::string size_9_by_6 =
    "field { field_length: 9000 field_width: 6000 goal_width: 1000 goal_depth: 200 boundary_width: 250 ";

}  // namespace

TEST(Geometry, ComesBackFromTheWire) {
  for (const world::Geometry& geometry : {year_2015(), division_a()}) {
    const std::optional<world::Geometry> back = wire::decode(encoded(geometry));
    ASSERT_TRUE(back.has_value());
    expect_same(*back, geometry);
    EXPECT_EQ(encoded(*back).SerializeAsString(), encoded(geometry).SerializeAsString());
  }
}

TEST(Geometry, SetsEveryFieldTheLeagueRequires) {
  EXPECT_THAT(league::missing_required(encoded(year_2015()), "ssl-vision HEAD"), IsEmpty());
  EXPECT_THAT(league::missing_required(encoded(division_a()), "ssl-vision HEAD"), IsEmpty());
}

TEST(Geometry, FitsTheEightKibibytesThatTheLeaguesProgramsRead) {
  EXPECT_LT(encoded(year_2015()).ByteSizeLong(), 8192U);
  EXPECT_LT(encoded(division_a()).ByteSizeLong(), 8192U);
}

TEST(Geometry, NamesTheMarkingsOf2015) {
  EXPECT_THAT(line_names(encoded(year_2015())),
              UnorderedElementsAre("TopTouchLine", "BottomTouchLine", "LeftGoalLine", "RightGoalLine",
                                   "HalfwayLine", "CenterLine", "LeftPenaltyStretch", "RightPenaltyStretch"));
  EXPECT_THAT(arc_names(encoded(year_2015())),
              UnorderedElementsAre("CenterCircle", "LeftFieldLeftPenaltyArc", "LeftFieldRightPenaltyArc",
                                   "RightFieldLeftPenaltyArc", "RightFieldRightPenaltyArc"));
  EXPECT_FALSE(encoded(year_2015()).field().has_penalty_area_depth());
}

TEST(Geometry, NamesTheMarkingsOfARectangle) {
  EXPECT_THAT(line_names(encoded(division_a())),
              UnorderedElementsAre("TopTouchLine", "BottomTouchLine", "LeftGoalLine", "RightGoalLine",
                                   "HalfwayLine", "CenterLine", "LeftPenaltyStretch", "RightPenaltyStretch",
                                   "LeftFieldLeftPenaltyStretch", "LeftFieldRightPenaltyStretch",
                                   "RightFieldLeftPenaltyStretch", "RightFieldRightPenaltyStretch"));
  EXPECT_THAT(arc_names(encoded(division_a())), ElementsAre("CenterCircle"));
  EXPECT_EQ(encoded(division_a()).field().penalty_area_depth(), 1800);
  EXPECT_EQ(encoded(division_a()).field().penalty_area_width(), 3600);
}

TEST(Geometry, PaintOf2015TouchesTheOuterEdgesFromInside) {
  const wire::proto::SSL_GeometryData message = encoded(year_2015());
  const auto& lines = message.field().field_lines();
  EXPECT_EQ(lines[0].p1().x(), -4495.0F);  // 4500 less half the line of 10
  EXPECT_EQ(lines[0].p1().y(), 2995.0F);
  EXPECT_EQ(lines[0].thickness(), 10.0F);
  for (const auto& arc : message.field().field_arcs()) {
    EXPECT_EQ(arc.radius(), arc.name() == "CenterCircle" ? 495.0F : 995.0F) << arc.name();
  }
}

TEST(Geometry, QuarterCirclesBulgeIntoTheField) {
  const wire::proto::SSL_GeometryData message = encoded(year_2015());
  for (const auto& arc : message.field().field_arcs()) {
    if (arc.name() == "CenterCircle") continue;
    const double middle = (static_cast<double>(arc.a1()) + static_cast<double>(arc.a2())) / 2;
    // The middle of the arc is nearer to the centre mark than the arc's centre,
    // and farther from the goal's axis.
    EXPECT_LT(std::cos(middle) * static_cast<double>(arc.center().x()), 0) << arc.name();
    EXPECT_GT(std::sin(middle) * static_cast<double>(arc.center().y()), 0) << arc.name();
    EXPECT_NEAR(static_cast<double>(arc.a2() - arc.a1()), std::numbers::pi / 2, 1e-6)
        << "floats of up to 2 pi";
  }
}

TEST(Geometry, ReadsTheMessageOf2015) {
  // SSL-Vision's defaults of that year: no types, no fields 8 to 17.
  const std::optional<world::Geometry> geometry = wire::decode(parse(size_9_by_6 + R"(
    field_lines { name: "LeftPenaltyStretch" p1 { x: -3500 y: -250 } p2 { x: -3500 y: 250 } thickness: 10 }
    field_arcs { name: "CenterCircle" center { x: 0 y: 0 } radius: 495 a1: 0 a2: 6.28 thickness: 10 }
    field_arcs { name: "LeftFieldLeftPenaltyArc" center { x: -4495 y: 250 } radius: 995 a1: 0 a2: 1.57 thickness: 10 }
  })"));
  ASSERT_TRUE(geometry.has_value());
  EXPECT_EQ(geometry->field.length, 9.0);
  EXPECT_EQ(geometry->field.goal_depth, 0.2);
  EXPECT_EQ(geometry->field.boundary_width, 0.25);
  EXPECT_EQ(geometry->field.defense_area.shape, Shape::QuarterCircles);
  EXPECT_NEAR(geometry->field.defense_area.radius, 1.0, exact);
  EXPECT_NEAR(geometry->field.defense_area.stretch, 0.5, exact);
  EXPECT_NEAR(geometry->field.center_circle_radius, 0.5, exact);
}

TEST(Geometry, ReadsARectangleFromLinesWhereverTheyAreDrawn) {
  // Before 2019-10 there are no fields 8 and 9; simulators draw the side stretch at the other sign of y.
  for (const std::string y : {"-1200", "1200"}) {
    const std::optional<world::Geometry> geometry =
        wire::decode(parse(size_9_by_6 + R"(
      field_lines { name: "LeftPenaltyStretch" p1 { x: -3300 y: 1200 } p2 { x: -3300 y: -1200 } thickness: 12 }
      field_lines { name: "LeftFieldLeftPenaltyStretch" p1 { x: -4500 y: )" +
                           y + " } p2 { x: -3300 y: " + y + R"( } thickness: 12 } })"));
    ASSERT_TRUE(geometry.has_value());
    EXPECT_EQ(geometry->field.defense_area.shape, Shape::Rectangle);
    EXPECT_NEAR(geometry->field.defense_area.depth, 1.2, exact);
    EXPECT_NEAR(geometry->field.defense_area.width, 2.4, exact);
    EXPECT_NEAR(geometry->field.line_thickness, 0.012, exact);
  }
}

TEST(Geometry, ReadsLinesByTypeWhenTheyHaveOtherNames) {
  const std::optional<world::Geometry> geometry = wire::decode(parse(size_9_by_6 + R"(
    field_lines { name: "a" p1 { x: -3300 y: 1200 } p2 { x: -3300 y: -1200 } thickness: 10 type: LeftPenaltyStretch }
    field_lines { name: "b" p1 { x: -4500 y: 1200 } p2 { x: -3300 y: 1200 } thickness: 10
                  type: LeftFieldLeftPenaltyStretch } })"));
  ASSERT_TRUE(geometry.has_value());
  EXPECT_EQ(geometry->field.defense_area.shape, Shape::Rectangle);
  EXPECT_NEAR(geometry->field.defense_area.depth, 1.2, exact);
}

TEST(Geometry, FindsTheCameraFromItsRotationAndTranslation) {
  // Half a turn about x looks straight down: t = -R C = (-x, y, z) for C = (1, 2, 4).
  const std::optional<world::Geometry> down = wire::decode(parse(size_9_by_6 + R"(} calib {
      camera_id: 3 q0: 1 q1: 0 q2: 0 q3: 0 tx: -1000 ty: 2000 tz: 4000 })"));
  ASSERT_EQ(down->cameras.size(), 1U);
  EXPECT_EQ(down->cameras[0].id, 3);
  EXPECT_LT((down->cameras[0].position - world::Vector3d(1, 2, 4)).norm(), exact);
}

TEST(Geometry, EncodedCameraAgreesWithItself) {
  wire::proto::SSL_GeometryData message = encoded(year_2015());
  const std::optional<world::Geometry> by_position = wire::decode(message);
  for (auto& calibration : *message.mutable_calib()) calibration.clear_derived_camera_world_tx();
  const std::optional<world::Geometry> by_rotation = wire::decode(message);
  ASSERT_EQ(by_rotation->cameras.size(), 4U);
  expect_same(*by_position, *by_rotation);
}

TEST(Geometry, DescribesTheCamerasOptics) {
  world::Geometry geometry = year_2015();
  geometry.cameras[1].focal_length = 612.5;
  geometry.cameras[1].image_width = 1001;
  geometry.cameras[1].image_height = 600;
  const wire::proto::SSL_GeometryCameraCalibration calibration = encoded(geometry).calib(1);
  EXPECT_EQ(calibration.focal_length(), 612.5F);
  EXPECT_EQ(calibration.principal_point_x(), 500.5F);
  EXPECT_EQ(calibration.principal_point_y(), 300.0F);
  EXPECT_EQ(calibration.distortion(), 0.0F);
  EXPECT_EQ(calibration.pixel_image_width(), 1001U);
  EXPECT_EQ(calibration.pixel_image_height(), 600U);
}

TEST(Geometry, KeepsTheOpticsThatMakeNoSenseOutOfACamera) {
  const std::optional<world::Geometry> geometry = wire::decode(parse(size_9_by_6 + R"(} calib {
      camera_id: 0 focal_length: nan pixel_image_width: 0 pixel_image_height: 4000000000
      derived_camera_world_tx: 0 derived_camera_world_ty: 0 derived_camera_world_tz: 4000 })"));
  ASSERT_EQ(geometry->cameras.size(), 1U);
  EXPECT_EQ(geometry->cameras[0].focal_length, world::Camera{}.focal_length);
  EXPECT_EQ(geometry->cameras[0].image_width, world::Camera{}.image_width);
  EXPECT_EQ(geometry->cameras[0].image_height, world::Camera{}.image_height);
}

TEST(Geometry, RefusesAFieldWithoutASensibleSize) {
  EXPECT_FALSE(wire::decode(wire::proto::SSL_GeometryData{}).has_value());
  EXPECT_FALSE(wire::decode(parse("field { field_length: 9000 }")).has_value());
  EXPECT_FALSE(wire::decode(parse("field { field_length: -9000 field_width: 6000 }")).has_value());
  EXPECT_FALSE(wire::decode(parse("field { field_length: 2000000000 field_width: 6000 }")).has_value());
  EXPECT_FALSE(wire::decode(parse("field { field_length: 9000 field_width: 499 }")).has_value());
  EXPECT_TRUE(wire::decode(parse("field { field_length: 9000 field_width: 500 }")).has_value());
}

TEST(Geometry, TakesNoMoreThan64Cameras) {
  world::Geometry geometry = division_a();
  wire::proto::SSL_GeometryData message = encoded(geometry);
  const auto calibration = message.calib(0);
  while (message.calib_size() < 1000) *message.add_calib() = calibration;
  EXPECT_EQ(wire::decode(message)->cameras.size(), 64U);
}

TEST(Geometry, IgnoresSingleValuesThatMakeNoSense) {
  const std::optional<world::Geometry> geometry = wire::decode(parse(size_9_by_6 + R"(
      line_thickness: -3 goal_height: -1 ball_radius: nan max_robot_radius: inf
      field_arcs { name: "CenterCircle" radius: nan } }
      calib { camera_id: 0 derived_camera_world_tx: nan derived_camera_world_ty: 0 derived_camera_world_tz: 0 }
      calib { camera_id: 4000000000 } calib { }
      models { straight_two_phase { acc_slide: 3 acc_roll: nan k_switch: 7 } })"));
  ASSERT_TRUE(geometry.has_value());
  const world::Geometry defaults;
  EXPECT_EQ(geometry->field.line_thickness, defaults.field.line_thickness);
  EXPECT_EQ(geometry->field.goal_height, defaults.field.goal_height);
  EXPECT_EQ(geometry->field.ball_radius, defaults.field.ball_radius);
  EXPECT_EQ(geometry->field.robot_radius, defaults.field.robot_radius);
  EXPECT_EQ(geometry->field.center_circle_radius, defaults.field.center_circle_radius);
  EXPECT_THAT(geometry->cameras, IsEmpty());
  EXPECT_EQ(geometry->ball_roll_deceleration, defaults.ball_roll_deceleration);
}

TEST(Geometry, ReadsTheMessageOf2010To2014) {
  matchday::legacy2014::SSL_GeometryData message;
  ASSERT_TRUE(google::protobuf::TextFormat::ParseFromString(R"(field {
      line_width: 10 field_length: 8090 field_width: 6050 boundary_width: 250 referee_width: 425 goal_width: 1000
      goal_depth: 180 goal_wall_width: 20 center_circle_radius: 500 defense_radius: 1000 defense_stretch: 350
      free_kick_from_defense_dist: 200 penalty_spot_from_field_line_dist: 750 penalty_line_from_spot_dist: 400 })",
                                                            &message));
  const std::optional<world::Geometry> geometry = wire::decode(message);
  ASSERT_TRUE(geometry.has_value());
  EXPECT_EQ(geometry->field.length, 8.09);
  EXPECT_EQ(geometry->field.width, 6.05);
  EXPECT_EQ(geometry->field.defense_area.radius, 1.0);
  EXPECT_EQ(geometry->field.defense_area.stretch, 0.35);
  EXPECT_EQ(geometry->field.penalty_mark_distance, 0.75);
}

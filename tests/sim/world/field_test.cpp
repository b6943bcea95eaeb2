#include "sim/world/field.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sim/world/random.h"

namespace world {
namespace {

Field division_a() {
  Field field;
  field.length = 12;
  field.width = 9;
  field.defense_area = {.shape = DefenseArea::Shape::Rectangle, .depth = 1.8, .width = 3.6};
  return field;
}

TEST(DefenseAreaDistance, QuarterCirclesReachOneMetreFromTheirCentres) {
  const Field field;  // 2015: radius 1 m around (+-4.5, +-0.25)
  EXPECT_DOUBLE_EQ(distance_to_defense_area(field, Side::Positive, {3.0, 0.1}), 0.5);
  EXPECT_DOUBLE_EQ(distance_to_defense_area(field, Side::Positive, {4.5, 2.25}), 1.0);
  EXPECT_DOUBLE_EQ(distance_to_defense_area(field, Side::Positive, {4.5, 0}), -1.0);
  // 3-4-5: 0.6 in front of and 0.8 beside the upper centre is on the line; the subtractions round once each.
  EXPECT_NEAR(distance_to_defense_area(field, Side::Positive, {3.9, 1.05}), 0.0, 1e-15);
}

TEST(DefenseAreaDistance, RectangleCountsTheNearestEdgeInsideAndTheCornerOutside) {
  const Field field = division_a();
  EXPECT_NEAR(distance_to_defense_area(field, Side::Negative, {-5.0, 0}), -0.8, 1e-15);
  EXPECT_NEAR(distance_to_defense_area(field, Side::Negative, {-4.2 + 0.3, 1.8 + 0.4}), 0.5, 1e-15);
}

TEST(DefenseAreaDistance, BothGoalsAndBothHalvesAreMirrorImages) {
  RandomStream stream(1, "field test");
  for (const Field& field : {Field{}, division_a()}) {
    for (int i = 0; i < 200; ++i) {
      const Vector2d p{stream.uniform() * 14 - 7, stream.uniform() * 10 - 5};
      const double here = distance_to_defense_area(field, Side::Positive, p);
      EXPECT_EQ(here, distance_to_defense_area(field, Side::Negative, {-p.x(), p.y()}));
      EXPECT_EQ(here, distance_to_defense_area(field, Side::Positive, {p.x(), -p.y()}));
    }
  }
}

TEST(MovedOutOfDefenseArea, EndsExactlyAtTheDistanceAndLeavesFarPointsAlone) {
  RandomStream stream(2, "field test");
  for (const Field& field : {Field{}, division_a()}) {
    for (int i = 0; i < 500; ++i) {
      const Vector2d p{stream.uniform() * field.half_length(), (stream.uniform() - 0.5) * field.width};
      const Vector2d moved = moved_out_of_defense_area(field, Side::Positive, p, 0.7);
      const double before = distance_to_defense_area(field, Side::Positive, p);
      if (before >= 0.7) {
        EXPECT_EQ(moved, p);
      } else {
        // Sums and differences of numbers below 8: a few ulp.
        EXPECT_GE(distance_to_defense_area(field, Side::Positive, moved), 0.7 - 1e-14);
      }
    }
  }
}

TEST(MovedOutOfDefenseArea, LeavesTheQuarterCirclesAlongTheRadius) {
  const Vector2d moved = moved_out_of_defense_area(Field{}, Side::Positive, {4.2, 0.65}, 0.0);
  EXPECT_NEAR(moved.x(), 4.5 - 0.6, 1e-12);
  EXPECT_NEAR(moved.y(), 0.25 + 0.8, 1e-12);
}

TEST(DistanceOutsideLines, IsNegativeInsideAndMeasuredToTheNearestLine) {
  const Field field;
  EXPECT_DOUBLE_EQ(distance_outside_lines(field, {0, 0}), -3.0);
  EXPECT_DOUBLE_EQ(distance_outside_lines(field, {4.0, 0}), -0.5);
  EXPECT_DOUBLE_EQ(distance_outside_lines(field, {0, -3.2}), 3.2 - 3.0);
}

TEST(QuarterCameras, StandAboveTheCentresOfTheQuarters) {
  const auto cameras = quarter_cameras(Field{});
  ASSERT_EQ(cameras.size(), 4u);
  Vector3d sum = Vector3d::Zero();
  for (const Camera& camera : cameras) {
    EXPECT_EQ(std::abs(camera.position.x()), 2.25);
    EXPECT_EQ(std::abs(camera.position.y()), 1.5);
    sum += camera.position;
  }
  EXPECT_EQ(sum, Vector3d(0, 0, 16));
}

TEST(CameraGrid, TakesAWiderLensWhereItsPartWouldNotFitTheImage) {
  EXPECT_EQ(quarter_cameras(Field{})[0].focal_length, 800.0);
  // One camera at 4 m: patterns at 0.15 m, walls 5.2 m away at the image's edge of 640 px: 640 x 3.85 / 5.2.
  EXPECT_EQ(camera_grid(Field{}, 1, 4)[0].focal_length, 473.0);
}

}  // namespace
}  // namespace world

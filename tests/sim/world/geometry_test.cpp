#include "sim/world/geometry.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace world {
namespace {

constexpr double pi = std::numbers::pi;
// Angles below a full turn are wrapped with one rounding of 2 pi, which is exact to an ulp of pi.
constexpr double one_rounding = 1e-15;

TEST(WrapAngle, KeepsAnglesThatAreInRangeBitForBit) {
  for (const double angle : {0.0, 1.0, -3.0, pi}) EXPECT_EQ(wrap_angle(angle), angle);
}

TEST(WrapAngle, MinusPiIsPi) { EXPECT_EQ(wrap_angle(-pi), pi); }

TEST(WrapAngle, RemovesWholeTurns) {
  EXPECT_NEAR(wrap_angle(1 + 2 * pi), 1, one_rounding);
  EXPECT_NEAR(wrap_angle(1 - 6 * pi), 1, 4 * one_rounding);
}

TEST(ClosestPoint, IsTheFootInsideAndTheEndOutside) {
  const Segment segment{{0, 0}, {2, 0}};
  EXPECT_EQ(closest_point(segment, {0.5, 3}), Vector2d(0.5, 0));
  EXPECT_EQ(closest_point(segment, {-1, 1}), Vector2d(0, 0));
  EXPECT_EQ(closest_point(segment, {5, -1}), Vector2d(2, 0));
  EXPECT_EQ(distance(segment, {5, 4}), 5.0);
}

TEST(ClosestPoint, OfASegmentWithoutLengthIsItsPoint) {
  EXPECT_EQ(closest_point({{1, 1}, {1, 1}}, {4, 5}), Vector2d(1, 1));
}

TEST(LineIntersection, MeetsBeyondTheEndsToo) {
  const auto point = line_intersection({{0, 0}, {1, 0}}, {{3, 1}, {3, 2}});
  ASSERT_TRUE(point);
  EXPECT_EQ(*point, Vector2d(3, 0));
}

TEST(LineIntersection, ParallelLinesNeverMeet) {
  EXPECT_FALSE(line_intersection({{0, 0}, {1, 1}}, {{1, 0}, {2, 1}}));
  EXPECT_FALSE(line_intersection({{0, 0}, {0, 0}}, {{1, 0}, {2, 1}}));
}

TEST(Rotated, AQuarterTurnSwapsTheAxes) {
  const Vector2d turned = rotated({1, 2}, pi / 2);
  EXPECT_NEAR(turned.x(), -2, one_rounding);
  EXPECT_NEAR(turned.y(), 1, one_rounding);
}

}  // namespace
}  // namespace world

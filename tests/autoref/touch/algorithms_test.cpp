#include "autoref/touch/algorithms.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace touch {
namespace {

constexpr double contact = 0.1115;  // [m] R + r

/// Positions n = 0, 1, ... frames ago.
template <class Course>
std::vector<Vector2d> history(int length, Course course) {
  std::vector<Vector2d> positions;
  for (int n = 0; n < length; ++n) positions.push_back(course(n));
  return positions;
}

std::vector<Vector2d> mirrored(std::vector<Vector2d> positions) {
  for (Vector2d& p : positions) p.y() = -p.y();
  return positions;
}

TEST(Accel, MeasuresHalfTheAcceleration) {
  // p = a t^2 / 2 with t in frames: the second difference is exactly a dt^2, the measure half of it (I-22).
  const Vector2d a(3, 4);
  const auto ball = history(3, [&](int n) -> Vector2d { return a * (n * n) / (2.0 * 60 * 60); });
  EXPECT_NEAR(accel_measure(ball), 2.5, 1e-12);
}

TEST(Accel, IsZeroForUniformMotion) {
  const auto ball = history(3, [](int n) { return Vector2d(1 - 0.1 * n, 0.05 * n); });
  EXPECT_NEAR(accel_measure(ball), 0, 1e-9);
}

TEST(Line, SeesABrokenLineThatMeetsAtTheRobot) {
  // In along -x to (0.12, 0), out along +y: pieces of three frames each, 0.05 m per frame.
  const auto d = history(
      6, [](int n) { return n < 3 ? Vector2d(0.12, 0.05 * (3 - n)) : Vector2d(0.12 + 0.05 * (n - 2), 0); });
  EXPECT_TRUE(line_says_touch(d, contact + 0.03));
  EXPECT_TRUE(line_says_touch(mirrored(d), contact + 0.03));
}

TEST(Line, DoesNotSeeABreakFarFromTheRobot) {
  const auto d = history(
      6, [](int n) { return n < 3 ? Vector2d(0.15, 0.05 * (3 - n)) : Vector2d(0.15 + 0.05 * (n - 2), 0); });
  EXPECT_FALSE(line_says_touch(d, contact + 0.03));  // they meet at 0.15 m, the bound is 0.1415 m
}

TEST(Line, DoesNotSeeAStraightCourse) {
  const auto d = history(6, [](int n) { return Vector2d(0.12, 0.05 * n - 0.1); });
  EXPECT_FALSE(line_says_touch(d, contact + 0.03));
}

TEST(Line, BoundOfTheAngleIsItsCosine) {
  // A bend of angle b at (0.1, 0): cos 0.99 is 8.11 degrees.
  const auto bent = [](double b) {
    return history(6, [b](int n) -> Vector2d {
      const Vector2d corner(0.1, 0);
      if (n >= 3) return corner + Vector2d(0, -0.05 * (n - 2));
      return corner + 0.05 * (3 - n) * world::direction(1.5707963267948966 + b);
    });
  };
  EXPECT_TRUE(line_says_touch(bent(0.143), contact + 0.03));   // 8.2 degrees
  EXPECT_FALSE(line_says_touch(bent(0.140), contact + 0.03));  // 8.0 degrees
}

TEST(Line, NeedsTheMiddleWithinATenthOfThePiece) {
  const auto with_middle = [](double off) {
    auto d = history(
        6, [](int n) { return n < 3 ? Vector2d(0.12, 0.05 * (3 - n)) : Vector2d(0.12 + 0.05 * (n - 2), 0); });
    d[1].x() += off;  // the piece d0 d2 is 0.1 m long
    return d;
  };
  EXPECT_TRUE(line_says_touch(with_middle(0.0099), contact + 0.03));
  EXPECT_FALSE(line_says_touch(with_middle(0.0101), contact + 0.03));
}

TEST(Line, BallAtRestOnTheRobotIsNoBrokenLine) {
  const auto d = history(6, [](int) { return Vector2d(0.1115, 0); });
  EXPECT_FALSE(line_says_touch(d, contact + 0.03));
}

TEST(Backtrack, SeesACourseThatComesOutOfTheRobot) {
  // 0.06 m per frame along +x: d3 = 0.13, so 0.07 m one frame and 0.01 m two frames earlier.
  const auto d = history(4, [](int n) { return Vector2d(0.31 - 0.06 * n, 0); });
  EXPECT_TRUE(backtrack_says_touch(d, contact, contact - 0.01));
  EXPECT_TRUE(backtrack_says_touch(mirrored(d), contact, contact - 0.01));
}

TEST(Backtrack, LooksTwoFramesBackAndNotThree) {
  // 0.03 m per frame: 0.13 m before d3 = 0.16 m, then 0.10 m at the second: inside 0.1015 m.
  const auto second = history(4, [](int n) { return Vector2d(0.25 - 0.03 * n, 0); });
  EXPECT_TRUE(backtrack_says_touch(second, contact, contact - 0.01));
  const auto third = history(4, [](int n) { return Vector2d(0.275 - 0.03 * n, 0); });
  EXPECT_FALSE(backtrack_says_touch(third, contact, contact - 0.01));  // 0.125 m at the second
}

TEST(Backtrack, DoesNotSeeABallThatPassesBy) {
  const auto d = history(4, [](int n) { return Vector2d(0.12, 0.2 - 0.06 * n); });
  EXPECT_FALSE(backtrack_says_touch(d, contact, contact - 0.01));
}

TEST(Backtrack, AbortsWhenTheCourseItselfCrossesTheRobot) {
  // A chip that flies over: between d1 and d2 it is above the robot, no sample is within R + r.
  const auto d = history(4, [](int n) { return Vector2d(0.36 - 0.24 * n, 0); });
  EXPECT_FALSE(backtrack_says_touch(d, contact, contact - 0.01));
}

TEST(Backtrack, SlowBallFromAKickerIsNeverATouch) {
  // The paper's version: still within R + r at d3, so it aborts (I-24). Documented, not wanted.
  const auto d = history(4, [](int n) { return Vector2d(0.14 - 0.01 * n, 0); });
  EXPECT_FALSE(backtrack_says_touch(d, contact, contact - 0.01));
}

TEST(Backtrack, FitIsLeastSquares) {
  // Errors orthogonal to a line's shape (e_n = +1, -1, -1, +1) leave the fit where it was; second way to
  // the same answer as without them.
  const auto course = [](double error) {
    auto d = history(4, [](int n) { return Vector2d(0.25 - 0.03 * n, 0); });
    d[0].y() += error, d[1].y() -= error, d[2].y() -= error, d[3].y() += error;
    return d;
  };
  // The bound is met exactly at the second extrapolated frame: 0.10 m.
  EXPECT_TRUE(backtrack_says_touch(course(0.005), contact, 0.1000001));
  EXPECT_FALSE(backtrack_says_touch(course(0.005), contact, 0.0999999));
}

TEST(LineAsCoded, WantsTheBreakBetweenThePieces) {
  // In along -x to (0.12, 0), out along +y, as above; then the same two lines, but the ball passes their
  // common point long before it turns: they meet at the robot and the paper's test is content.
  const auto at_break = history(
      6, [](int n) { return n < 3 ? Vector2d(0.12, 0.05 * (3 - n)) : Vector2d(0.12 + 0.05 * (n - 2), 0); });
  EXPECT_TRUE(line_says_touch_as_coded(at_break, contact + 0.03));
  const auto elsewhere =
      history(6, [](int n) { return n < 3 ? Vector2d(0.1, 0.3 - 0.05 * n) : Vector2d(0.05 * (n - 5), 0); });
  EXPECT_TRUE(line_says_touch(elsewhere, contact + 0.03));
  EXPECT_FALSE(line_says_touch_as_coded(elsewhere, contact + 0.03));
}

TEST(BacktrackAsCoded, SeesTheSlowBallThatThePapersMisses) {
  // Out of contact with 0.01 m per frame (I-24): within R + r, which only the paper's version minds.
  const auto slow = history(8, [](int n) { return Vector2d(0.14 - 0.01 * n, 0); });
  EXPECT_FALSE(backtrack_says_touch(slow, contact, contact - 0.01));
  EXPECT_TRUE(backtrack_says_touch_as_coded(slow, 0.0685, contact - 0.01));
}

TEST(BacktrackAsCoded, AbortsWhenTheOlderCourseWasInsideTheRobot) {
  const auto over = history(8, [](int n) { return Vector2d(0.20 - 0.03 * n, 0); });  // passes the centre
  EXPECT_FALSE(backtrack_says_touch_as_coded(over, 0.0685, contact - 0.01));
}

}  // namespace
}  // namespace touch

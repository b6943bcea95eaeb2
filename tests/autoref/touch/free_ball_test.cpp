#include "autoref/touch/free_ball.h"

#include <gtest/gtest.h>

namespace touch {
namespace {

constexpr Carpet carpet{};  // 3 and 0.26 m/s^2
constexpr double exact = 1e-12;

// A solid sphere without spin rolls at 5/7 of its speed; until then it slides v t - a t^2 / 2.
TEST(FreeBall, RollsAtFiveSeventhsOfItsSpeed) {
  FreeBall ball{.velocity = {2.1, 0}};
  const double slides = 2.1 * 2 / 7 / carpet.slide;  // 0.2 s
  const Vector2d way = move(ball, slides, carpet);
  EXPECT_NEAR(ball.velocity.x(), 1.5, exact);
  EXPECT_NEAR(ball.spin.x(), 1.5, exact);
  EXPECT_NEAR(way.x(), (2.1 + 1.5) / 2 * slides, exact);
}

TEST(FreeBall, RollsUntilItStops) {
  FreeBall ball{.velocity = {0.52, 0}, .spin = {0.52, 0}};
  EXPECT_NEAR(move(ball, 5, carpet).x(), 0.52, exact);  // v^2 / 2a after 2 s
  EXPECT_NEAR(ball.velocity.norm(), 0, exact);
}

TEST(FreeBall, GoesTheSameWayInPieces) {
  FreeBall whole{.velocity = {2, 1}, .spin = {-1, 0.5}, .climb = 0.6};
  FreeBall pieces = whole;
  const Vector2d once = move(whole, 0.5, carpet);
  Vector2d way = Vector2d::Zero();
  for (int n = 0; n < 50; ++n) way += move(pieces, 0.01, carpet);
  EXPECT_NEAR((once - way).norm(), 0, 1e-9);  // rounding of 50 steps
  EXPECT_NEAR((whole.velocity - pieces.velocity).norm(), 0, 1e-9);
}

// A ball that still rolls forward when it comes off a wall is slowed down by its spin: its course is bent.
TEST(FreeBall, IsBentByItsSpin) {
  FreeBall ball{.velocity = {1, 1}, .spin = {-1, 1}};
  move(ball, 0.05, carpet);
  EXPECT_LT(ball.velocity.x(), 0.9);
  EXPECT_NEAR(ball.velocity.y(), 1, exact);
}

// The front of a rolling ball goes down; friction at a wall throws it up with 2/7 of its speed. In the
// simulator balls of 2 m/s hop 17 to 21 mm, of 3 m/s 36 to 42 mm (medians of two seasons of self-play).
TEST(FreeBall, ThatRollsHopsOffAHull) {
  FreeBall ball{.velocity = {-2, 0}, .spin = {-2, 0}};
  bounce(ball, {1, 0}, Vector2d::Zero(), 0.57);
  EXPECT_NEAR(ball.velocity.x(), 0.57 * 2, exact);
  EXPECT_NEAR(ball.climb, 2 * 2.0 / 7, exact);
  EXPECT_NEAR(ball.spin.x(), -2 * 2.0 / 7, exact);
  move(ball, ball.climb / 9.81, carpet);
  EXPECT_NEAR(ball.height, 0.0167, 0.0001);
}

TEST(FreeBall, ThatSlidesDoesNotHopOffAHull) {
  FreeBall ball{.velocity = {-2, 0}};
  bounce(ball, {1, 0}, Vector2d::Zero(), 0.57);
  EXPECT_FALSE(ball.hops());
}

// Friction sideways is at most 0.22 of the push, and ends when the ball rolls along the hull.
TEST(FreeBall, IsRubbedSideways) {
  FreeBall fast{.velocity = {-1, 3}};
  bounce(fast, {1, 0}, Vector2d::Zero(), 0.57);
  EXPECT_NEAR(fast.velocity.y(), 3 - 0.22 * 1.57, exact);
  FreeBall slow{.velocity = {-1, 0.7}};
  bounce(slow, {1, 0}, Vector2d::Zero(), 0.57);
  EXPECT_NEAR(slow.velocity.y(), 0.5, exact);
}

TEST(FreeBall, LandsAndStays) {
  FreeBall ball{.velocity = {1, 0}, .spin = {1, 0}, .climb = 0.6};
  move(ball, 1, carpet);  // 18 mm high, then 5 mm, which is no hop any more
  EXPECT_TRUE(ball.rolls());
}

}  // namespace
}  // namespace touch

#include "teams/reference/with_ball.h"

#include <gtest/gtest.h>

#include <string_view>

#include "teams/reference/winner.h"
#include "tests/teams/support/views.h"

namespace reference {
namespace {

using support::put;
using support::running;

// A robot at the centre mark that looks along x, the ball at its dribbler.
class AtTheBall : public testing::Test {
 protected:
  AtTheBall() : view_(running({0.0945, 0})) {
    put(view_.own, 1, {0, 0});
    hold_ = {view_.ball.position, 0.5};
    kick_.kind = Kick::Kind::Pass;
    kick_.speed = 4;
  }
  WithBall choose(double direction, double their_time = 9) {
    kick_.direction = direction;
    return choose_with_ball(view_, view_.own.front(), kick_, hold_, their_time, parameters_);
  }
  kit::View view_;
  Kick kick_;
  Hold hold_;
  Parameters parameters_;
};

TEST_F(AtTheBall, TheFeatureDecidesBetweenTurnAndReleaseFromTwelveDegreesOn) {
  const double degree = M_PI / 180;
  for (const double side : {1.0, -1.0}) {
    EXPECT_EQ(choose(side * 11 * degree), WithBall::Align);
    EXPECT_EQ(choose(side * 13 * degree), WithBall::Turn);
  }
  parameters_.turn_dribble = false;
  for (const double side : {1.0, -1.0}) {
    EXPECT_EQ(choose(side * 11 * degree), WithBall::Align);
    EXPECT_EQ(choose(side * 13 * degree), WithBall::Release);
  }
}

TEST_F(AtTheBall, TheFirstThreeFramesAreForTheBar) {
  hold_.time = 2.0 / 60;
  EXPECT_EQ(choose(2), WithBall::Settle);
  hold_.time = 0.06;
  EXPECT_EQ(choose(2), WithBall::Turn);
}

TEST_F(AtTheBall, CarriesAlongTheHeadingWhenThereIsNothingToKickAt) {
  kick_.kind = Kick::Kind::Dribble;
  EXPECT_EQ(choose(0.1), WithBall::Carry);
}

TEST_F(AtTheBall, ADribbleEndsWithAKickAheadBeforeTheMetreOfTheLaws) {
  hold_.start = view_.ball.position - Vector2d(parameters_.dribble_distance + 0.01, 0);
  EXPECT_EQ(choose(1), WithBall::KickAhead);
  // Looking home in the own half it is let go of instead.
  view_.own.front().position = {-2, 0};
  view_.own.front().orientation = M_PI;
  view_.ball.position = {-2.0945, 0};
  hold_.start = {-1, 0};
  EXPECT_EQ(choose(1), WithBall::Release);
}

TEST_F(AtTheBall, WithoutTheFeatureItLetsGoOnlyWhenItGetsRoundFirst) {
  parameters_.turn_dribble = false;
  EXPECT_EQ(choose(2, 3.0), WithBall::Release);
  EXPECT_EQ(choose(2, 0.5), WithBall::KickAhead);
}

TEST_F(AtTheBall, OnlyTheWayToAlignDiffersBetweenOnAndOff) {
  // Whatever is not a turn is ordered alike.
  Parameters off = parameters_;
  off.turn_dribble = false;
  const kit::Robot& robot = view_.own.front();
  for (const WithBall what : {WithBall::Settle, WithBall::Align, WithBall::Carry, WithBall::KickAhead}) {
    const skills::Order a = order_with_ball(view_, robot, what, kick_, hold_, 0, parameters_);
    const skills::Order b = order_with_ball(view_, robot, what, kick_, hold_, 0, off);
    EXPECT_EQ(a.kick_speed, b.kick_speed);
    EXPECT_EQ(a.heading, b.heading);
    EXPECT_EQ(a.velocity.has_value(), b.velocity.has_value());
    EXPECT_EQ(a.velocity.value_or(Vector2d::Zero()), b.velocity.value_or(Vector2d::Zero()));
  }
}

TEST_F(AtTheBall, TurningIsSoonerThanGoingRound) {
  Parameters off = parameters_;
  off.turn_dribble = false;
  for (const double angle : {0.5, 1.0, 2.0, 3.0}) {
    EXPECT_LT(time_to_align(view_, view_.own.front(), angle, parameters_),
              time_to_align(view_, view_.own.front(), angle, off));
    EXPECT_EQ(time_to_align(view_, view_.own.front(), angle, off),
              time_to_align(view_, view_.own.front(), -angle, off));
  }
}

TEST(OneTouch, ShootsABallThatComesFromTheSideAndStopsOneFromBehind) {
  kit::View view = running({3, 2}, {0, -3});
  const kit::Robot& robot = put(view.own, 1, {3, 0});
  const skills::Meeting meeting{{3, 0.09}, 0.6, true};
  const Parameters parameters;
  const auto kick = choose_one_touch(view, robot, meeting, parameters, {});
  ASSERT_FALSE(kick) << "straight in front of the goal the ball would have to be turned by 90 degrees";
  view.ball.velocity = {-2, -2.2};
  view.ball.position = {4, 2};
  EXPECT_TRUE(choose_one_touch(view, robot, meeting, parameters, {}));
  view.ball.velocity = {3, 0};
  EXPECT_FALSE(choose_one_touch(view, robot, meeting, parameters, {}));
}

// The ball rolls beside the hull, never at the dribbler: law 12 counts that too.
TEST(Push, ABallAlongTheHullIsLetGoBeforeTheMetreOfTheLaws) {
  Winner winner;
  Observer observer;
  kit::View view = running({0, 0.12}, {1, 0});
  put(view.own, 1, {0, 0}, -M_PI / 2);  // looks the other way
  view.own.front().velocity = {1, 0};
  double let_go_at = -1;
  for (double x = 0; x < 1 && let_go_at < 0; x += 1.0 / world::ticks_per_second) {
    view.ball.position.x() = view.own.front().position.x() = x;
    ++view.tick;
    view.time += 1.0 / world::ticks_per_second;
    const skills::Order order = winner.play(view, observer.observe(view), view.own.front(), {}, {});
    if (std::string_view(order.why) == "let go") let_go_at = x;
    if (let_go_at >= 0) {
      EXPECT_LT(order.velocity->y(), 0);
    }
  }
  // dribble_distance less 0.2 s of its way, a tick, and a tenth of a metre between the places kept.
  EXPECT_NEAR(let_go_at, Parameters{}.dribble_distance - 0.2, 0.12);
}

// There and back: straight from the far end it is a metre, though the ball is near where contact began.
TEST(Push, TheWayOfADribbleCountsFromItsFarthestPlace) {
  Winner winner;
  Observer observer;
  kit::View view = running({0, 0.12}, {1, 0});
  put(view.own, 1, {0, 0}, -M_PI / 2);
  const double step = 1.0 / world::ticks_per_second;
  std::string_view why;
  double x = 0;
  for (; x < 0.5; x += step) {
    view.ball.position.x() = view.own.front().position.x() = x;
    ++view.tick, view.time += step;
    EXPECT_STRNE(winner.play(view, observer.observe(view), view.own.front(), {}, {}).why, "let go");
  }
  view.ball.velocity = {-1, 0};
  for (; x > -0.5 && why != "let go"; x -= step) {
    view.ball.position.x() = view.own.front().position.x() = x;
    ++view.tick, view.time += step;
    why = winner.play(view, observer.observe(view), view.own.front(), {}, {}).why;
  }
  EXPECT_NEAR(x, 0.5 - (Parameters{}.dribble_distance - 0.2), 0.12);
}

}  // namespace
}  // namespace reference

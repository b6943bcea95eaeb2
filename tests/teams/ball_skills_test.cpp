// The skills at the ball without a simulator: given a view, which order.

#include <gtest/gtest.h>

#include <cmath>

#include "teams/kit/ball_course.h"
#include "teams/skills/ball_handling.h"
#include "teams/skills/motion.h"
#include "teams/skills/receive.h"
#include "teams/skills/turn_dribble.h"
#include "tests/teams/support/views.h"

namespace skills {
namespace {

using support::put;
using support::running;

kit::Ball chip(double speed, double climb) {
  kit::Ball ball;
  ball.known = ball.flies = true;
  ball.velocity = {speed, 0};
  ball.climb = climb;
  return ball;
}

TEST(BallCourse, AChipFliesAParabolaAndLandsAfterTwiceItsClimbOverG) {
  const kit::BallCourse course(chip(3, 2), {});
  EXPECT_NEAR(course.lands_after(), 4 / 9.81, 1e-12);
  EXPECT_NEAR(course.height(2 / 9.81), 4 / (2 * 9.81), 1e-12);
  EXPECT_NEAR(course.distance(4 / 9.81), 3 * 4 / 9.81, 1e-9);
}

TEST(BallCourse, EachHopIsAQuarterAsHighAndHalfAsLongAsTheOneBefore) {
  const kit::BallCourse course(chip(3, 3), {});
  const double first = 6 / 9.81;
  const double second = first / 2;
  EXPECT_NEAR(course.height(first + second / 2), 9 / (2 * 9.81) / 4, 1e-9);
  EXPECT_NEAR(course.height(first + second + second / 4), 9 / (2 * 9.81) / 16, 1e-9);
  // The first landing takes 2/7 of 3 m/s, friction would allow .35 * 1.5 * 3.
  EXPECT_NEAR(course.speed(first + 0.01), 3 * 5.0 / 7, 1e-12);
}

TEST(BallCourse, OnTheGroundItIsTheModel) {
  kit::Ball ball;
  ball.velocity = {3, 4};
  ball.rolls_below = 3;
  const kit::BallModel model;
  EXPECT_NEAR(kit::BallCourse(ball, model).distance(1.2), model.distance_after(5, 3, 1.2), 1e-12);
}

TEST(BallCourse, ForetellingInTwoStepsIsForetellingInOne) {
  const kit::BallModel model;
  const kit::Ball once = kit::predicted(chip(3, 3), model, 0.9);
  const kit::Ball twice = kit::predicted(kit::predicted(chip(3, 3), model, 0.4), model, 0.5);
  EXPECT_LT((once.position - twice.position).norm(), 1e-9);
  EXPECT_NEAR(once.height, twice.height, 1e-9);
}

TEST(Meet, AChipIsNotMetWhereItFliesHigh) {
  kit::View view = running({0, 0});
  view.ball = chip(3, 3);
  const kit::Robot& robot = put(view.own, 1, {2.5, 0.2});
  const kit::BallModel model(view.geometry);
  const Meeting meeting = meet(view, robot, driving_limits(robot.specs), model, 0.0945);
  ASSERT_TRUE(meeting.before_it_stops);
  EXPECT_LE(kit::BallCourse(view.ball, model).height(meeting.time), highest_capture);
  EXPECT_GT(meeting.time, 0.5);
}

TEST(TurnDribble, TheBallMovesOnItsCircleWhateverTheTurn) {
  kit::View view = running({0.0945, 0});
  const kit::Robot& robot = put(view.own, 1, {0, 0});
  for (const double rate : {5.0, -5.0}) {
    const TurnCircle circle = turn_circle(5);
    const Vector2d centre = carrying_velocity(robot, circle, rate, 0.0215);
    // Velocity of the point of the rigid body where the ball is: centre's plus rate times
    // its place turned left.
    const Vector2d ball = centre + rate * Vector2d(0, 0.0945);
    EXPECT_NEAR(ball.norm(), 5 * circle.radius, 1e-12);
    // phi is the angle from the direction of travel to the heading, towards the inside.
    const double side = rate > 0 ? 1 : -1;
    EXPECT_NEAR(world::wrap_angle(0 - world::angle_of(ball)) * side, circle.phi, 1e-12);
  }
}

TEST(TurnDribble, InPlaceTheCentreRests) {
  kit::View view = running({0.0945, 0});
  const kit::Robot& robot = put(view.own, 1, {0, 0}, 1.3);
  EXPECT_LT(carrying_velocity(robot, {6, 0.0945, -M_PI / 2}, 6, 0.0215).norm(), 1e-12);
}

TEST(TurnDribble, TheTableGoesOnFromRowToRow) {
  for (double rate = 3; rate < 10; rate += 0.01) {
    EXPECT_NEAR(turn_circle(rate + 0.01).phi, turn_circle(rate).phi, 0.005);
  }
}

TEST(TurnAndKick, KicksOnlyWhenAlignedAndNearlyAtRest) {
  kit::View view = running({0.0945, 0});
  kit::Robot& robot = put(view.own, 1, {0, 0});
  EXPECT_EQ(turn_and_kick(view, robot, 0.03, 5, 0, 0.05).kick_speed, 5);
  EXPECT_EQ(turn_and_kick(view, robot, 0.3, 5, 0, 0.05).kick_speed, 0);
  robot.angular_velocity = 5;
  EXPECT_EQ(turn_and_kick(view, robot, 0.03, 5, 0, 0.05).kick_speed, 0);
}

TEST(Shielding, DriftsAwayFromTheNearestOpponentAtMostThirtyCentimetresASecond) {
  kit::View view = running({0.0945, 0});
  const kit::Robot& robot = put(view.own, 1, {0, 0});
  EXPECT_EQ(shielding_drift(view, robot), Vector2d::Zero());
  put(view.opponents, 1, {0.2, 0});
  put(view.opponents, 2, {0, -0.5});
  const Vector2d drift = shielding_drift(view, robot);
  EXPECT_NEAR(drift.x(), -0.3, 1e-12);
  EXPECT_NEAR(drift.y(), 0, 1e-12);
}

TEST(Orbit, StaysOnItsCircleWithTheAirTheFeatureAsksFor) {
  kit::View view = running({0, 0});
  const kit::Robot& robot = put(view.own, 1, {0.09 + 0.0215 + 0.03, 0});
  const Vector2d velocity = orbit_velocity(view.ball, robot, 0, 0.0215);
  // On the circle, a half circle to go: along the tangent only, v^2 <= a r.
  EXPECT_NEAR(velocity.x(), 0, 1e-9);
  EXPECT_LE(velocity.squaredNorm(), driving_limits(robot.specs).acceleration * 0.1415);
  EXPECT_GT(velocity.norm(), 0.5);
}

TEST(Orbit, IsMirroredWithTheDirection) {
  kit::View view = running({0, 0});
  const kit::Robot& robot = put(view.own, 1, {0.15, 0});
  const Vector2d left = orbit_velocity(view.ball, robot, 1, 0.0215);
  const Vector2d right = orbit_velocity(view.ball, robot, -1, 0.0215);
  EXPECT_NEAR(left.x(), right.x(), 1e-12);
  EXPECT_NEAR(left.y(), -right.y(), 1e-12);
}

TEST(Release, TakesTheSpinOutBeforeItBacksOff) {
  kit::View view = running({0.0945, 0});
  const kit::Robot& robot = put(view.own, 1, {0, 0});
  EXPECT_TRUE(release(robot, 0).dribble);
  EXPECT_EQ(*release(robot, 0).velocity, Vector2d::Zero());
  EXPECT_FALSE(release(robot, 0.1).dribble);
  EXPECT_LT(release(robot, 0.1).velocity->x(), 0);
}

TEST(KickAhead, ChipsOverARobotInFront) {
  kit::View view = running({0.0945, 0});
  const kit::Robot& robot = put(view.own, 1, {0, 0});
  EXPECT_EQ(kick_ahead(view, robot, 2.5).kick_angle, 0);
  put(view.opponents, 1, {0.35, 0.02});
  EXPECT_GT(kick_ahead(view, robot, 2.5).kick_angle, 0);
}

TEST(Receive, StandsOnTheBallsLineAndLooksAtIt) {
  kit::View view = running({0, 0}, {3.5, 0});
  const kit::Robot& robot = put(view.own, 1, {2, 0.1}, M_PI);
  const Order order = receive(view, robot, kit::BallModel(view.geometry));
  EXPECT_NEAR(order.target.y(), 0, 1e-12);
  EXPECT_NEAR(std::abs(order.heading), M_PI, 1e-12);
  EXPECT_TRUE(order.dribble);
}

TEST(Redirect, PutsTheMiddleOfTheFrontOnTheBallsLine) {
  kit::View view = running({0, 0}, {3.5, 0});
  const kit::Robot& robot = put(view.own, 1, {2, 0.1}, M_PI - 0.7);
  const double direction = M_PI - 0.7;
  const auto meeting = arrival(view, robot, kit::BallModel(view.geometry), direction);
  ASSERT_TRUE(meeting);
  const Order order = redirect(view, robot, *meeting, direction, 6, 0.1);
  const Vector2d front = order.target + 0.0945 * world::direction(direction);
  EXPECT_NEAR(front.y(), 0, 1e-9);
  EXPECT_NEAR(redirect_angle(view.ball.velocity, direction), 0.7, 1e-12);
}

TEST(Redirect, IsArmedOnlyWhenTheBallIsNearlyThere) {
  kit::View view = running({0, 0}, {3.5, 0});
  const kit::Robot& robot = put(view.own, 1, {2, 0}, M_PI);
  EXPECT_EQ(redirect(view, robot, {{1.9, 0}, 0.6, true}, M_PI, 6, 0.1).kick_speed, 0);
  EXPECT_EQ(redirect(view, robot, {{1.9, 0}, 0.1, true}, M_PI, 6, 0.1).kick_speed, 6);
  EXPECT_EQ(redirect(view, robot, {{1.9, 0}, 0.1, true}, M_PI - 0.3, 6, 0.1).kick_speed, 0);
}

TEST(CrossTrack, EndsOnTheLineAndNeverAsksForMoreThanTheLimits) {
  const Limits limits{3, 3, 6};
  Vector2d place(0, 0), velocity(-1.5, 0.4);
  const Vector2d target(-0.4, 0.3), along(1, 0);
  for (int i = 0; i < 120; ++i) {
    const Vector2d next = cross_track_velocity(target - place, velocity, along, limits);
    EXPECT_LE((next - velocity).norm() * 60, limits.brake + 1e-9);
    place += 0.5 * (velocity + next) / 60;
    velocity = next;
  }
  // A millimetre: the last tick's rest.
  EXPECT_LT((place - target).norm(), 0.001);
}

TEST(Wall, ABallIsAtAWallWhenNoRobotFitsBehindIt) {
  kit::View view = running({0, 3.3});
  EXPECT_FALSE(is_at_wall(view));  // 0.4 m of room
  view.ball.position = {0, 3.6};
  EXPECT_TRUE(is_at_wall(view));
  const kit::Robot& robot = put(view.own, 1, {0, 2});
  EXPECT_NEAR(free_from_wall(view, robot).heading, M_PI / 2, 1e-12);
}

}  // namespace
}  // namespace skills

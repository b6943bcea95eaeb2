#include <gtest/gtest.h>

#include <cmath>

#include "teams/skills/aim.h"
#include "teams/skills/ball_handling.h"
#include "teams/skills/intercept.h"
#include "teams/skills/pass.h"
#include "teams/skills/path.h"
#include "teams/skills/steer.h"
#include "tests/teams/support/views.h"

namespace skills {
namespace {

using support::put;
using support::running;

TEST(BallModel, KickSpeedForArrivesAtTheSpeedAskedFor) {
  const kit::BallModel model;
  for (const double distance : {0.5, 2.0, 6.0}) {
    for (const double arrival : {0.5, 2.0, 4.0}) {
      const double kick = model.kick_speed_for(distance, arrival);
      const double time = model.time_to_cover(kick, kick * model.switch_ratio, distance);
      // 1e-9: closed forms both ways.
      EXPECT_NEAR(model.speed_after(kick, kick * model.switch_ratio, time), arrival, 1e-9);
      EXPECT_NEAR(model.distance_after(kick, kick * model.switch_ratio, time), distance, 1e-9);
    }
  }
}

TEST(BallModel, ARollingBallStopsAfterVSquaredByTwoA) {
  const kit::BallModel model;
  EXPECT_NEAR(model.stopping_distance(1, 5), 1 / (2 * 0.26), 1e-12);
  EXPECT_EQ(model.time_to_cover(1, 5, 3), std::numeric_limits<double>::infinity());
}

TEST(WidestOpening, OfAnEmptyGoalIsTheAngleBetweenThePosts) {
  const Opening opening = widest_opening({0, 0}, {{1, -1}, {1, 1}}, {});
  EXPECT_NEAR(opening.width, M_PI / 2, 1e-12);
  EXPECT_NEAR(opening.direction, 0, 1e-12);
  EXPECT_LT((opening.target - Vector2d(1, 0)).norm(), 1e-12);
}

TEST(WidestOpening, TakesTheWiderSideOfABlocker) {
  // A disc of radius 0.1 at 1 m, 0.2 rad to the left, covers 0.2 +- asin(0.1).
  const Blocker blocker{world::direction(0.2), 0.1};
  const Opening opening = widest_opening({0, 0}, {{2, -2}, {2, 2}}, std::span(&blocker, 1));
  EXPECT_NEAR(opening.width, M_PI / 4 + 0.2 - std::asin(0.1), 1e-12);
  EXPECT_LT(opening.direction, 0);
}

TEST(WidestOpening, IsZeroWhenAllIsBlocked) {
  const Blocker blocker{{0.5, 0}, 0.6};
  EXPECT_EQ(widest_opening({0, 0}, {{1, -1}, {1, 1}}, std::span(&blocker, 1)).width, 0);
}

TEST(WidestOpening, IgnoresWhatStandsBehindTheGoal) {
  const Blocker blocker{{1.5, 0}, 0.2};
  EXPECT_NEAR(widest_opening({0, 0}, {{1, -1}, {1, 1}}, std::span(&blocker, 1)).width, M_PI / 2, 1e-12);
}

TEST(WidestOpening, KeepsTheSideAimedAtBeforeUnlessTheOtherIsMuchWider) {
  const Blocker blocker{{1, 0.001}, 0.2};  // the right is wider by a hair
  const world::Segment goal{{2, -1}, {2, 1}};
  EXPECT_LT(widest_opening({0, 0}, goal, std::span(&blocker, 1)).direction, 0);
  EXPECT_GT(widest_opening({0, 0}, goal, std::span(&blocker, 1), 0.3).direction, 0);
}

TEST(PassSafety, FallsWithAnOpponentOnTheLine) {
  kit::View view = running({0, 0});
  const kit::BallModel model;
  const double free = pass_safety(view, model, {0, 0}, {3, 0}, 5);
  put(view.opponents, 1, {1.5, 0.6});
  const double near = pass_safety(view, model, {0, 0}, {3, 0}, 5);
  view.opponents.clear();
  put(view.opponents, 1, {1.5, 0});
  EXPECT_GT(free, 0.99);
  EXPECT_LT(near, free);
  EXPECT_LT(pass_safety(view, model, {0, 0}, {3, 0}, 5), 0.05);
}

TEST(PassSafety, FallsTheNearerTheOpponentIsToTheLine) {
  const kit::BallModel model;
  double before = 1;
  for (const double beside : {1.2, 0.9, 0.6, 0.4, 0.2, 0.0}) {
    kit::View view = running({0, 0});
    put(view.opponents, 1, {2.0, beside});
    const double safety = pass_safety(view, model, {0, 0}, {3, 0}, 4);
    EXPECT_LE(safety, before) << beside;
    before = safety;
  }
}

TEST(PassSafety, IsTheSameOnBothSides) {
  const kit::BallModel model;
  kit::View view = running({0, 0}), mirror = running({0, 0});
  put(view.opponents, 1, {1.4, 0.5}).velocity = {0.3, -0.4};
  put(mirror.opponents, 1, {1.4, -0.5}).velocity = {0.3, 0.4};
  EXPECT_DOUBLE_EQ(pass_safety(view, model, {0, 0.2}, {3, 0.1}, 4),
                   pass_safety(mirror, model, {0, -0.2}, {3, -0.1}, 4));
}

TEST(PlanChip, GoesOverWhoBlocksTheGroundAndLandsBeyond) {
  kit::View view = running({0, 0});
  const kit::BallModel model;
  EXPECT_FALSE(plan_chip(view, model, {0, 0}, {3, 0})) << "the ground is free";
  put(view.opponents, 1, {0.6, 0.05});
  const auto chip = plan_chip(view, model, {0, 0}, {3, 0});
  ASSERT_TRUE(chip);
  const double carry = chip->speed * chip->speed * std::sin(2 * chip->angle) / 9.81;
  EXPECT_GE(carry, 0.6 + 0.09 + 0.3 - 1e-9);
  EXPECT_LE(carry, 3 - 0.2 + 1e-9);
  EXPECT_GT(chip->safety, pass_safety(view, model, {0, 0}, {3, 0}, 4));
}

TEST(PlanChip, DoesNotTryToRiseThroughARobotAtTheBall) {
  kit::View view = running({0, 0});
  put(view.opponents, 1, {0.2, 0});
  EXPECT_FALSE(plan_chip(view, {}, {0, 0}, {3, 0}));
}

TEST(GoalieLater, GoesIntoTheWayNoFasterThanItCan) {
  kit::View view = running({3, 2});
  kit::Robot& goalie = put(view.opponents, 1, {4.2, 0.3});
  EXPECT_EQ(goalie_later(view, goalie, {3, -2}, 0), goalie.position);
  // After 0.12 s of reaction: t^2 / (2 (1 / a + 1 / b)).
  const double slowness = 2 * (1 / goalie.specs.max_acceleration + 1 / goalie.specs.max_brake);
  EXPECT_NEAR((goalie_later(view, goalie, {3, -2}, 0.42) - goalie.position).norm(), 0.09 / slowness, 1e-9);
  const Vector2d there = goalie_later(view, goalie, {3, -2}, 5);
  const Vector2d way = Vector2d(3, -2) - view.their_goal(), out = there - view.their_goal();
  EXPECT_NEAR(way.x() * out.y() - way.y() * out.x(), 0, 1e-9) << "between ball and goal";
}

TEST(WidthToGoal, IsTheWidthOfTheOpening) {
  kit::View view = running({3, 0.5});
  put(view.own, 2, {3.8, 0.4});
  put(view.opponents, 1, {4.2, -0.1});
  EXPECT_DOUBLE_EQ(width_to_goal(view, {3, 0.5}, 6.5, -1), opening_to_goal(view, {3, 0.5}, 6.5, -1).width);
  EXPECT_GT(width_to_goal(view, {3, 0.5}, 6.5, -1), 0);
}

TEST(Meet, ARobotAtRestMeetsARestingBallWhereItLies) {
  kit::View view = running({1, 1});
  const kit::Robot& robot = put(view.own, 1, {0, 0});
  const Meeting meeting = meet(view, robot, driving_limits(robot.specs), kit::BallModel(view.geometry), 0.09);
  EXPECT_EQ(meeting.position, Vector2d(1, 1));
}

TEST(Meet, IsOnTheBallsWayAndInTime) {
  kit::View view = running({0, 0}, {2, 0});
  const kit::Robot& robot = put(view.own, 1, {2, 1});
  const Limits limits = driving_limits(robot.specs);
  const kit::BallModel model(view.geometry);
  const Meeting meeting = meet(view, robot, limits, model, 0.09);
  ASSERT_TRUE(meeting.before_it_stops);
  EXPECT_NEAR(meeting.position.y(), 0, 1e-12);
  EXPECT_NEAR(meeting.position.x(), model.distance_after(2, view.ball.rolls_below, meeting.time), 1e-9);
  const Vector2d to = meeting.position + Vector2d(0.09, 0) - robot.position;
  EXPECT_LE(travel_time(to, robot.velocity, limits), meeting.time - 0.1 + 1e-6);
}

TEST(FindPath, IsStraightWhenNothingIsInTheWay) {
  Obstacles obstacles;
  obstacles.add({{1, 2}, 0.3, false});
  const Path path = find_path({0, 0}, {2, 0}, obstacles, 0);
  EXPECT_EQ(path.via, Vector2d(2, 0));
  EXPECT_EQ(path.side, 0);
}

TEST(FindPath, PassesADiscOnTheShorterSideWithoutCuttingIt) {
  Obstacles obstacles;
  obstacles.add({{1, 0.1}, 0.3, false});
  const Path path = find_path({0, 0}, {2, 0}, obstacles, 0);
  EXPECT_EQ(path.side, -1);
  EXPECT_GE(world::distance(world::Segment{{0, 0}, path.via}, {1, 0.1}), 0.3);
  EXPECT_GT(path.length, 2);
}

TEST(FindPath, KeepsItsSideWhenTheOtherIsOnlyALittleShorter) {
  Obstacles obstacles;
  obstacles.add({{1, 0.02}, 0.3, false});
  EXPECT_EQ(find_path({0, 0}, {2, 0}, obstacles, 0).side, -1);
  EXPECT_EQ(find_path({0, 0}, {2, 0}, obstacles, 1).side, 1);
}

TEST(FindPath, DoesNotGoBehindTheGoalWhereTheWallIs) {
  kit::View view = running({0, 0});
  const kit::Robot& robot = put(view.own, 1, {5.05, -1.45});
  Order order;
  order.target = {3.2, 0.3};
  const Obstacles obstacles = obstacles_for(view, robot, order);
  for (const int side_before : {-1, 0, 1}) {
    const Path path = find_path(robot.position, order.target, obstacles, side_before);
    EXPECT_LT(path.via.x(), 4.5) << "in front of the goal, side " << side_before;
  }
}

TEST(FindPath, LeavesAnAreaByTheShortestWay) {
  Obstacles obstacles;
  obstacles.add({{0, 0}, 0.7, true});
  const Path path = find_path({0.5, 0}, {-3, 0}, obstacles, 0);
  EXPECT_GT(path.via.x(), 0.7);
  EXPECT_NEAR(path.via.y(), 0, 1e-12);
}

TEST(Steering, DoesNotDriveIntoARobotThatStandsInFront) {
  kit::View view = running({0, 2});
  put(view.own, 1, {0, 0});
  put(view.opponents, 1, {0.2, 0});  // 2 cm of air
  const Vector2d velocity = without_collisions(view, view.own[0], {2, 0}, 0.015);
  // With 5 mm beyond the margin it may close at sqrt(6 * 0.005) = 0.17 m/s.
  EXPECT_NEAR(velocity.x(), std::sqrt(6 * 0.005), 1e-9);
}

TEST(Steering, MovesTargetsOutOfTheAreas) {
  kit::View view = running({0, 0});
  const kit::Robot& robot = put(view.own, 1, {0, 0});
  Order order;
  order.target = view.own_goal();
  EXPECT_GE(
      world::distance_to_defense_area(view.field(), world::Side::Negative, legal_target(view, robot, order)),
      robot.specs.radius);
  order.enter_own_area = true;
  EXPECT_EQ(legal_target(view, robot, order), view.own_goal());
}

TEST(ApproachAndKick, ArmsTheKickerOnlyWhenAligned) {
  kit::View view = running({0, 0});
  kit::Robot& robot = put(view.own, 1, {-0.1, 0});
  EXPECT_EQ(approach_and_kick(view, robot, 0, 6, 0, 0.05).kick_speed, 6);
  robot.orientation = 0.2;
  EXPECT_EQ(approach_and_kick(view, robot, 0, 6, 0, 0.05).kick_speed, 0);
}

TEST(ApproachAndKick, GoesBehindTheBallFirst) {
  kit::View view = running({0, 0});
  const kit::Robot& robot = put(view.own, 1, {1, 0});
  const Order order = approach_and_kick(view, robot, 0, 6, 0, 0.05);
  EXPECT_LT(order.target.x(), -0.09);
  EXPECT_EQ(order.kick_speed, 0);
  EXPECT_GE(order.ball_distance, 0);
}

}  // namespace
}  // namespace skills

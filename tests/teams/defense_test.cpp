// The reference team against the ball: each decision given a view, without a simulator.

#include "teams/reference/defense.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "sim/world/random.h"
#include "teams/reference/assignment.h"
#include "teams/reference/goalie.h"
#include "teams/reference/legal.h"
#include "teams/reference/possession.h"
#include "teams/reference/restart.h"
#include "teams/reference/roles.h"
#include "tests/teams/support/views.h"

namespace reference {
namespace {

using support::put;
using support::running;

const Parameters parameters;

double cost_of(const Costs& costs, const std::array<std::size_t, most_to_assign>& robot_of) {
  double sum = 0;
  for (std::size_t task = 0; task < costs.tasks; ++task) sum += costs.of[task][robot_of[task]];
  return sum;
}

TEST(Assignment, IsTheBestOfAllPermutations) {
  world::RandomStream random(1, "costs");
  for (int trial = 0; trial < 200; ++trial) {
    Costs costs;
    costs.tasks = 1 + random.below(4);
    costs.robots = costs.tasks + random.below(3);
    for (std::size_t task = 0; task < costs.tasks; ++task) {
      for (std::size_t robot = 0; robot < costs.robots; ++robot)
        costs.of[task][robot] = random.uniform() - 0.2;
    }
    std::array<std::size_t, most_to_assign> order{};
    std::iota(order.begin(), order.end(), 0u);
    double best = 1e9;
    do {
      best = std::min(best, cost_of(costs, order));
    } while (std::next_permutation(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(costs.robots)));
    EXPECT_NEAR(cost_of(costs, assign(costs)), best, 1e-12) << trial;  // sums of up to four doubles
  }
}

TEST(Assignment, GivesNoRobotTwoTasks) {
  Costs costs;
  costs.tasks = costs.robots = 5;
  for (std::size_t task = 0; task < 5; ++task) costs.of[task][2] = -1;  // all want the same one
  auto robot_of = assign(costs);
  std::sort(robot_of.begin(), robot_of.begin() + 5);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(robot_of[i], i);
}

// Lets the tracker see `seconds` of the view.
Possession after(PossessionTracker& tracker, kit::View& view, double seconds) {
  Possession possession = Possession::None;
  for (int i = 0; i < seconds * world::ticks_per_second; ++i) {
    view.time += world::tick_length;
    possession = tracker.update(view);
  }
  return possession;
}

TEST(PossessionTracker, TakesATenthOfASecondToGetTheBallAndOneAndAHalfToLoseIt) {
  kit::View view = running({0, 0});
  put(view.own, 1, {-0.1, 0});
  PossessionTracker tracker;
  EXPECT_EQ(after(tracker, view, 0.05), Possession::None);
  EXPECT_EQ(after(tracker, view, 0.1), Possession::Ours);
  view.ball.position = {2, 0};  // passed on
  EXPECT_EQ(after(tracker, view, 1.3), Possession::Ours);
  EXPECT_EQ(after(tracker, view, 0.3), Possession::None);
}

TEST(PossessionTracker, KnowsWhenBothAreAtTheBallAndWhenTheOthersTookIt) {
  kit::View view = running({0, 0});
  put(view.own, 1, {-0.1, 0});
  put(view.opponents, 1, {0.1, 0});
  PossessionTracker tracker;
  EXPECT_EQ(after(tracker, view, 0.2), Possession::Contested);
  view.own[0].position = {-1, 0};
  EXPECT_EQ(after(tracker, view, 0.2), Possession::Theirs);
}

TEST(PossessionTracker, ABallInTheAirIsNobodys) {
  kit::View view = running({0, 0});
  view.ball.height = 0.2;
  put(view.own, 1, {-0.1, 0});
  PossessionTracker tracker;
  EXPECT_EQ(after(tracker, view, 0.5), Possession::None);
}

TEST(Formation, EverybodyDefendsAgainstABallInOurHalf) {
  EXPECT_EQ(formation(5, Possession::Theirs, -2, parameters).defenders, 4);
  EXPECT_GE(formation(5, Possession::Ours, 2, parameters).supports, 2);
}

// Ours on the own side, four of theirs in front of our goal.
kit::View besieged() {
  kit::View view = running({-2.5, 1.5});
  put(view.own, 0, {-4.3, 0});
  put(view.own, 1, {-3.3, 0.2});
  put(view.own, 2, {-3.2, -0.4});
  put(view.own, 3, {-2, -1});
  put(view.own, 4, {-1.5, 0.5});
  put(view.own, 5, {-2.2, 1.2});
  put(view.opponents, 1, {-2.4, 1.5});
  put(view.opponents, 2, {-2.6, -0.9});
  put(view.opponents, 3, {-1.4, 0});
  put(view.opponents, 4, {0.3, -2});
  return view;
}

kit::View mirrored(kit::View view) {
  view.ball.position.y() *= -1;
  view.ball.velocity.y() *= -1;
  for (auto* robots : {&view.own, &view.opponents}) {
    for (kit::Robot& robot : *robots) {
      robot.position.y() *= -1;
      robot.velocity.y() *= -1;
      robot.orientation *= -1;
    }
  }
  return view;
}

TEST(Defense, ASingleRobotInTheWallTakesTheSideTheGoalieLeaves) {
  kit::View view = running({-1.5, 0});
  kit::Robot& goalie = put(view.own, 0, {-4.2, 0});
  const double behind_each_other = wall_position(view, 0, 1).y();
  EXPECT_NEAR(behind_each_other, 0, 1e-12);
  goalie.position.y() = 0.2;
  const Vector2d place = wall_position(view, 0, 1);
  // On the line from the ball to a point 0.15 m beside the goal's middle, but for the
  // last 5 mm out of the area.
  EXPECT_NEAR(place.y() / (place.x() + 1.5), -0.15 / -3.0, 0.005 / 1.5);
  goalie.position.y() = -0.2;
  EXPECT_NEAR(wall_position(view, 0, 1).y(), -place.y(), 1e-12);
  EXPECT_NEAR(wall_position(view, 0, 2).y(), -wall_position(view, 1, 2).y(), 1e-12) << "two close the middle";
}

TEST(Defense, EveryTaskGoesToAnotherRobot) {
  const kit::View view = besieged();
  Observer observer;
  const Situation& situation = observer.observe(view);
  const Roles roles = assign_roles(view, situation, {}, {1, 3, 1}, {});
  EXPECT_EQ(roles.defense.count, 3u);
  std::array<int, 3> robots_with{};
  for (const kit::Robot& robot : view.own) {
    if (roles.of(robot.number) == Role::Defender) {
      ++robots_with.at(static_cast<std::size_t>(roles.index[robot.number]));
    }
  }
  EXPECT_EQ(robots_with, (std::array<int, 3>{1, 1, 1}));
}

TEST(Defense, MarksWhoCouldShootNextAndNotTheRobotAtTheBall) {
  const kit::View view = besieged();
  Observer observer;
  const Situation& situation = observer.observe(view);
  ASSERT_EQ(situation.their_first, 1);
  const DefensePlan plan = plan_defense(view, situation, 3, {});
  std::vector<int> marked;
  for (std::size_t i = 0; i < plan.count; ++i) {
    if (plan.tasks[i].kind == DefenseTask::Kind::Mark) marked.push_back(plan.tasks[i].opponent);
  }
  EXPECT_THAT(marked, testing::UnorderedElementsAre(2, 3));
}

TEST(Defense, KeepsMarkingAgainstAnEqualThreat) {
  kit::View view = running({0, 0});
  put(view.opponents, 1, {-2, 1});
  put(view.opponents, 2, {-2, -1});
  Situation situation;
  DefensePlan before;
  before.count = 1;
  for (const int marked : {1, 2}) {
    before.tasks[0] = {DefenseTask::Kind::Mark, 0, 1, marked};
    const DefensePlan plan = plan_defense(view, situation, 2, before);
    EXPECT_EQ(plan.tasks[1].opponent, marked);
  }
}

TEST(Defense, IsTheSameInTheMirror) {
  const kit::View view = besieged(), mirror = mirrored(view);
  Observer one, two;
  const DefensePlan a = plan_defense(view, one.observe(view), 4, {});
  const DefensePlan b = plan_defense(mirror, two.observe(mirror), 4, {});
  ASSERT_EQ(a.count, b.count);
  std::vector<Vector2d> places, mirror_places;
  for (std::size_t i = 0; i < a.count; ++i) {
    Vector2d place = task_position(mirror, b.tasks[i]);
    place.y() *= -1;
    mirror_places.push_back(place);
    places.push_back(task_position(view, a.tasks[i]));
  }
  for (const Vector2d& place : places) {
    EXPECT_TRUE(std::any_of(mirror_places.begin(), mirror_places.end(), [&](const Vector2d& other) {
      return (place - other).norm() < 1e-9;
    })) << place.transpose();
  }
}

TEST(Goalie, IsTheSameInTheMirror) {
  kit::View view = besieged();
  for (const Vector2d& velocity : {Vector2d(0, 0), Vector2d(-4, -2.2), Vector2d(-3, 0)}) {
    view.ball.velocity = velocity;
    const kit::View mirror = mirrored(view);
    Observer one, two;
    const skills::Order a = play_goalie(view, one.observe(view), view.own[0]);
    const skills::Order b = play_goalie(mirror, two.observe(mirror), mirror.own[0]);
    EXPECT_STREQ(a.why, b.why);
    EXPECT_NEAR(a.target.x(), b.target.x(), 1e-9);
    EXPECT_NEAR(a.target.y(), -b.target.y(), 1e-9);
  }
}

TEST(Goalie, ComesOutUntilItClosesTheOpening) {
  kit::View view = running({-3.6, 0.6});
  const kit::Robot& robot = put(view.own, 0, {-4.3, 0});
  const Vector2d& ball = view.ball.position;
  const double opening = std::atan2(1.1, 0.9) - std::atan2(0.1, 0.9);  // to the posts at y = -0.5 and 0.5
  const double hidden = 2 * std::asin(0.1115 / (guard_position(view, robot) - ball).norm());
  // It stays 30 % of the way from the ball, which costs 0.03 rad here.
  EXPECT_NEAR(hidden, opening, 0.05);
}

// Kept within the goal's width it stood beside the line of every shot from a flank.
TEST(Goalie, StaysOnTheLineToABallOnTheFlank) {
  kit::View view = running({-3.6, 1.8});
  const kit::Robot& robot = put(view.own, 0, {-4.3, 0.2});
  const Vector2d place = guard_position(view, robot);
  const double near = std::atan2(-1.3, -0.9), far = std::atan2(-2.3, -0.9);  // from the ball to the posts
  // The opening is inset by the ball's radius at both posts, which shifts its middle by less than this.
  EXPECT_NEAR(world::angle_of(place - view.ball.position), (near + far) / 2, 0.02);
}

TEST(Goalie, GoesOutOnlyToABallItReachesFirst) {
  kit::View view = running({-3.2, 0});
  put(view.own, 0, {-4.2, 0});
  put(view.opponents, 1, {-1.2, 0});
  Observer near;
  EXPECT_TRUE(goes_out(view, near.observe(view), view.own[0]));
  view.opponents[0].position = {-2.9, 0};
  Observer beaten;
  EXPECT_FALSE(goes_out(view, beaten.observe(view), view.own[0]));
}

TEST(Goalie, AloneItLeavesTheGoalOnlyWithTimeToSpare) {
  kit::View view = running({-2, 0});
  put(view.own, 0, {-2.3, 0});
  put(view.opponents, 1, {3, 0});
  Observer alone;
  EXPECT_TRUE(may_leave_goal(view, alone.observe(view), view.own[0]));
  view.own[0].position = {-4.3, 0};
  view.opponents[0].position = {-1.5, 0};
  Observer pressed;
  EXPECT_FALSE(may_leave_goal(view, pressed.observe(view), view.own[0]));
}

TEST(Penalty, TheGoalieStaysOnTheLineAndLeansToWhereTheKickerLooks) {
  kit::View view = running({-3.5, 0});
  const kit::Robot& robot = put(view.own, 0, {-4.48, 0});
  put(view.opponents, 3, {-3.4, 0}, M_PI - 0.3);  // looks at (-4.5, 0.31)
  const skills::Order order = face_penalty(view, robot);
  EXPECT_NEAR(order.target.x(), -4.48, 1e-9);
  EXPECT_NEAR(order.target.y(), 0.5 * std::tan(0.3), 1e-9);
}

TEST(Legal, AnyPlaceAroundAnyBallKeepsTheDistanceAndStaysOutOfTheAreas) {
  kit::View view = running({0, 0});
  const kit::Robot& robot = put(view.own, 1, {0, 0});
  world::RandomStream random(2, "places");
  const auto anywhere = [&random] { return Vector2d(9 * random.uniform() - 4.5, 6 * random.uniform() - 3); };
  for (int i = 0; i < 2000; ++i) {
    const Vector2d ball = anywhere();
    const Vector2d place = clear_of_ball(view, robot, anywhere(), ball, 0.6, false);
    EXPECT_GE((place - ball).norm(), 0.6 + 0.09 + 0.0215 - 1e-9);
    for (const world::Side side : {world::Side::Negative, world::Side::Positive}) {
      EXPECT_GT(world::distance_to_defense_area(view.field(), side, place), 0.09) << ball.transpose();
    }
    EXPECT_LT(world::distance_outside_lines(view.field(), place), 0.25);
  }
}

TEST(Legal, APlaceThatIsFreeIsKept) {
  kit::View view = running({0, 0});
  const kit::Robot& robot = put(view.own, 1, {0, 0});
  EXPECT_EQ(clear_of_ball(view, robot, {2, 1}, {0, 0}, 0.6, false), Vector2d(2, 1));
}

}  // namespace
}  // namespace reference

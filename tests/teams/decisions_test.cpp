#include <gtest/gtest.h>

#include "teams/reference/choose_kick.h"
#include "teams/reference/defense.h"
#include "teams/reference/goalie.h"
#include "teams/reference/reference_team.h"
#include "teams/reference/restart.h"
#include "teams/reference/roles.h"
#include "tests/teams/support/views.h"

namespace reference {
namespace {

using support::put;
using support::running;

const Parameters parameters;

TEST(Formation, HasOneGoalieAndAlwaysAWinner) {
  for (int players = 1; players <= 5; ++players) {
    for (const Possession possession : {Possession::None, Possession::Ours, Possession::Theirs}) {
      const Formation f = formation(players, possession, 0, parameters);
      EXPECT_EQ(f.winners + f.defenders + f.supports, players);
      EXPECT_EQ(f.winners, 1);
    }
  }
  EXPECT_EQ(formation(0, Possession::Ours, 0, parameters).winners, 0);
}

TEST(Formation, DefendsWithMoreWhenTheyHaveTheBallInOurHalf) {
  EXPECT_GT(formation(5, Possession::Theirs, -2, parameters).defenders,
            formation(5, Possession::Ours, 2, parameters).defenders);
}

TEST(Roles, TheRefereesKeeperIsTheGoalieElseTheLowestNumber) {
  kit::View view = running({0, 0});
  put(view.own, 2, {-4, 0});
  put(view.own, 5, {-1, 0});
  view.game.own_keeper = 5;
  EXPECT_EQ(goalie_of(view), 5);
  view.game.own_keeper = 0;
  EXPECT_EQ(goalie_of(view), 2);
}

TEST(Roles, TheFirstAtTheBallWinsItAndKeepsTheTaskAgainstAnEqual) {
  kit::View view = running({0, 0});
  put(view.own, 0, {-4, 0});
  put(view.own, 1, {-1, 0.5});
  put(view.own, 2, {-0.9, -0.5});
  Observer observer;
  for (int i = 0; i < 3; ++i, ++view.tick) observer.observe(view);
  const Situation& situation = observer.observe(view);
  const Formation f{1, 1, 0};
  EXPECT_EQ(assign_roles(view, situation, {}, f, {}).winner, 2);
  Roles before;
  before.winner = 1;
  EXPECT_EQ(assign_roles(view, situation, before, f, {}).winner, 1);
  EXPECT_EQ(assign_roles(view, situation, before, f, 2).winner, 2) << "the receiver of a pass";
}

TEST(Roles, WhoTookTheFreeKickIsNotTheWinner) {
  kit::View view = running({0, 0});
  put(view.own, 0, {-4, 0});
  put(view.own, 1, {-0.2, 0});
  put(view.own, 2, {-2, 0});
  view.game.forbidden = 1;
  Observer observer;
  EXPECT_EQ(assign_roles(view, observer.observe(view), {}, {1, 1, 0}, {}).winner, 2);
}

TEST(ChooseKick, ShootsAtAnOpenGoal) {
  kit::View view = running({3, 0});
  put(view.own, 1, {2.9, 0});
  put(view.own, 2, {3, 2});
  Observer observer;
  const Kick kick = choose_kick(view, observer.observe(view), 1, {}, parameters, {});
  EXPECT_EQ(kick.kind, Kick::Kind::Shot);
  EXPECT_NEAR(kick.direction, 0, 1e-9);
  EXPECT_LE(kick.speed, 7.0);
}

TEST(ChooseKick, PassesFromAnIndirectKick) {
  kit::View view = running({3, 0});
  put(view.own, 1, {2.9, 0});
  put(view.own, 2, {3, 2});
  Observer observer;
  const Kick kick = choose_kick(view, observer.observe(view), 1, {.shot_allowed = false, .must_kick = true},
                                parameters, {});
  EXPECT_EQ(kick.kind, Kick::Kind::Pass);
  EXPECT_EQ(kick.receiver, 2);
}

TEST(ChooseKick, ClearsFromTheOwnHalfUnderPressure) {
  kit::View view = running({-3, 1});
  put(view.own, 1, {-3.1, 1});
  put(view.opponents, 1, {-2.6, 1});
  Observer observer;
  const Kick kick = choose_kick(view, observer.observe(view), 1, {}, parameters, {});
  EXPECT_EQ(kick.kind, Kick::Kind::Clear);
  EXPECT_GT(std::cos(kick.direction), 0.3) << "upfield";
}

TEST(ChooseKick, NeverPassesAcrossTheOwnGoal) {
  kit::View view = running({-2.4, 2});
  put(view.own, 1, {-2.5, 2});
  put(view.own, 2, {-3, -1.8});
  Observer observer;
  const Kick kick = choose_kick(view, observer.observe(view), 1, {}, parameters, {});
  EXPECT_NE(kick.kind, Kick::Kind::Pass);
}

TEST(ChooseKick, IsTheSameInTheMirror) {
  kit::View view = running({2, 1});
  put(view.own, 1, {1.9, 1});
  put(view.own, 2, {3, -1});
  put(view.opponents, 0, {4.2, 0.2});
  kit::View mirror = view;
  mirror.ball.position.y() *= -1;
  for (auto* robots : {&mirror.own, &mirror.opponents}) {
    for (kit::Robot& robot : *robots) robot.position.y() *= -1;
  }
  Observer one, two;
  const Kick a = choose_kick(view, one.observe(view), 1, {}, parameters, {});
  const Kick b = choose_kick(mirror, two.observe(mirror), 1, {}, parameters, {});
  EXPECT_EQ(a.kind, b.kind);
  EXPECT_NEAR(a.direction, -b.direction, 1e-9);
}

TEST(Goalie, StandsOnTheBisectorInFrontOfTheGoal) {
  kit::View view = running({0, 0});
  const kit::Robot& robot = put(view.own, 0, {-4.3, 0});
  const Vector2d place = guard_position(view, robot);
  EXPECT_NEAR(place.y(), 0, 1e-12);
  EXPECT_GT(place.x(), -4.5);
  EXPECT_LT(place.x(), -3.6);
}

TEST(Goalie, GoesIntoTheWayOfAShot) {
  kit::View view = running({-2, 0}, {-5, 0.8});
  put(view.own, 0, {-4.3, 0});
  Observer observer;
  const skills::Order order = play_goalie(view, observer.observe(view), view.own[0]);
  EXPECT_STREQ(order.why, "save");
  const world::Segment shot{{-2, 0}, {-4.5, 0.4}};
  EXPECT_LT(world::distance(shot, order.target), 1e-6);
}

TEST(Goalie, ClearsABallAtRestInItsArea) {
  kit::View view = running({-4, 0.5});
  put(view.own, 0, {-4.3, 0});
  Observer observer;
  const skills::Order order = play_goalie(view, observer.observe(view), view.own[0]);
  EXPECT_STREQ(order.why, "clear");
}

TEST(Defense, TheWallStandsOutsideTheAreaBetweenBallAndGoal) {
  kit::View view = running({-1, 1.5});
  for (int index = 0; index < 2; ++index) {
    const Vector2d place = wall_position(view, index, 2);
    EXPECT_GT(world::distance_to_defense_area(view.field(), world::Side::Negative, place),
              view.field().robot_radius);
    EXPECT_LT(world::distance(world::Segment{view.own_goal(), view.ball.position}, place), 0.2);
  }
  EXPECT_GT((wall_position(view, 0, 2) - wall_position(view, 1, 2)).norm(), 2 * view.field().robot_radius);
}

TEST(Defense, ANearerOpponentIsTheWorseThreat) {
  kit::View view = running({-1, 1});
  put(view.opponents, 1, {-3, 0});
  put(view.opponents, 2, {2, -2});
  EXPECT_LT(threat_time(view, view.opponents[0]), threat_time(view, view.opponents[1]));
}

// A full team of ours and theirs in a line-up, in some phase.
kit::View full(kit::Phase phase, bool ours, const Vector2d& ball) {
  kit::View view = running(ball);
  view.game.phase = phase;
  view.game.ours = ours;
  view.game.restart_position = ball;
  const double y[] = {0, 1.2, -1.2, 2.2, -2.2, 0.3};
  for (int i = 0; i < 6; ++i) {
    put(view.own, i, {i == 0 ? -4.3 : -1.0 - 0.3 * i, y[i]});
    put(view.opponents, i, {i == 0 ? 4.3 : 1.0 + 0.3 * i, -y[i]});
  }
  return view;
}

TEST(ReferenceTeam, CommandsNoKickNoDribblerAndNoMoreThanTheLimitWhileStopped) {
  kit::View view = full(kit::Phase::Stop, false, {0, 0});
  ReferenceTeam team({}, {});
  world::TeamCommands commands;
  for (int i = 0; i < 60; ++i, ++view.tick) {
    view.time += world::tick_length;
    commands.clear();
    team.play(view, commands);
    ASSERT_EQ(commands.size(), 6u);
    for (const world::RobotCommand& command : commands) {
      EXPECT_LE(command.velocity_local.norm(), 1.4 + 1e-9);
      EXPECT_EQ(command.kick_speed, 0);
      EXPECT_EQ(command.dribbler_speed, 0);
      const Vector2d target = team.order_of(command.number).target;
      EXPECT_GE((target - view.ball.position).norm() - 0.09 - 0.0215, 0.5) << int{command.number};
    }
  }
}

TEST(ReferenceTeam, StaysInItsHalfUntilTheKickoffIsTaken) {
  for (const bool ours : {true, false}) {
    kit::View view = full(kit::Phase::PrepareKickoff, ours, {0, 0});
    ReferenceTeam team({}, {});
    world::TeamCommands commands;
    team.play(view, commands);
    for (const kit::Robot& robot : view.own) {
      EXPECT_LT(team.order_of(robot.number).target.x(), -robot.specs.radius) << int{robot.number} << ours;
    }
  }
}

TEST(ReferenceTeam, KeepsHalfAMetreFromTheirFreeKick) {
  kit::View view = full(kit::Phase::IndirectFree, false, {-2.5, 1});
  ReferenceTeam team({}, {});
  world::TeamCommands commands;
  team.play(view, commands);
  for (const kit::Robot& robot : view.own) {
    EXPECT_GE((team.order_of(robot.number).target - view.ball.position).norm(), 0.5 + 0.09 + 0.0215);
  }
}

TEST(ReferenceTeam, PlaysWithAnySubsetOfItsRobots) {
  for (int robots = 1; robots <= 6; ++robots) {
    kit::View view = full(kit::Phase::Running, false, {0, 0});
    view.own.erase(view.own.begin(), view.own.end() - robots);
    ReferenceTeam team({}, {});
    world::TeamCommands commands;
    team.play(view, commands);
    EXPECT_EQ(commands.size(), static_cast<std::size_t>(robots));
    EXPECT_EQ(team.roles().goalie, view.own.front().number);
    EXPECT_GE(team.roles().winner, 0) << "the only robot is goalie and winner";
    EXPECT_EQ(team.roles().winner == team.roles().goalie, robots == 1);
  }
}

TEST(ReferenceTeam, LeavesTheBallInTheOwnAreaToTheGoalie) {
  kit::View view = full(kit::Phase::Running, false, {-4.1, 0.4});
  ReferenceTeam team({}, {});
  world::TeamCommands commands;
  team.play(view, commands);
  EXPECT_STREQ(team.order_of(0).why, "pass out");
  EXPECT_STREQ(team.order_of(team.roles().winner).why, "wait for goalie");
}

}  // namespace
}  // namespace reference

// Short games in this process: engine, filter and team objects, with a real referee or one scripted here.

#include <gtest/gtest.h>

#include "teams/chaser/chaser.h"
#include "teams/reference/reference_team.h"
#include "tests/teams/support/arena.h"

namespace {

using support::Arena;
using support::Side;
using world::CommandKind;
using world::Team;

Side reference_side() {
  Side side;
  side.make = [](const kit::Setup& setup) {
    return std::make_unique<reference::ReferenceTeam>(setup, reference::Parameters{});
  };
  return side;
}

Side chaser_side() {
  Side side;
  side.make = [](const kit::Setup&) { return std::make_unique<chaser::Chaser>(); };
  return side;
}

// Ticks until the ball is in the goal at -x (blue defends +x and so attacks it), or -1 after `seconds`.
std::int64_t ticks_to_goal(Arena& arena, double seconds) {
  while (world::seconds(arena.engine().time()) < seconds) {
    arena.tick();
    if (arena.engine().truth().ball.position.x() < -4.53) return arena.engine().tick();
  }
  return -1;
}

TEST(ReferenceTeam, ScoresAgainstAnEmptySideWithinAMinute) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    Arena arena({}, reference_side(), seed);
    arena.tell({CommandKind::Start});
    EXPECT_GT(ticks_to_goal(arena, 60), 0) << "seed " << seed;
  }
}

TEST(Chaser, ScoresAgainstAnEmptySideWithinAMinute) {
  Arena arena({}, chaser_side(), 1);
  arena.tell({CommandKind::Start});
  EXPECT_GT(ticks_to_goal(arena, 60), 0);
}

TEST(ReferenceTeam, IsSlowAndHalfAMetreAwayFourSecondsAfterAStop) {
  // A game in which the ball does not stop before a defense area: there (five seeds of twenty) defenders that
  // would have to go through their own area stay too near.
  Arena arena(reference_side(), reference_side(), 6);
  arena.tell({CommandKind::Start});
  for (int i = 0; i < 600; ++i) arena.tick();
  arena.tell({CommandKind::Stop});
  // 4 s: everyone within 0.5 m has 0.6 m to go at 1.4 m/s, and the ball may still roll at 1 m/s at first.
  for (int i = 0; i < 240; ++i) arena.tick();
  for (int i = 0; i < 120; ++i) {
    arena.tick();
    const truth::Frame& truth = arena.engine().truth();
    const double ball_speed = truth.ball.velocity.head<2>().norm();
    for (const truth::Robot& robot : truth.robots) {
      EXPECT_LT(robot.velocity.norm(), 1.5);
      if (ball_speed > 0.3) continue;  // a ball that rolls at a robot is not the robot's fault
      EXPECT_GT((robot.position - truth.ball.position.head<2>()).norm() - 0.09, 0.5)
          << world::name(robot.id.team) << int{robot.id.number};
    }
  }
}

TEST(ReferenceTeam, LeavesTheDefenseAreasToTheGoalies) {
  Arena arena(reference_side(), reference_side(), 5);
  arena.tell({CommandKind::Start});
  const world::Field field;
  int inside = 0;
  for (int i = 0; i < 60 * 60; ++i) {
    arena.tick();
    const truth::Frame& truth = arena.engine().truth();
    for (const truth::Contact& contact : truth.contacts) {
      if (contact.robot.number == 0) continue;
      for (const truth::Robot& robot : truth.robots) {
        if (robot.id != contact.robot) continue;
        for (const world::Side side : {world::Side::Negative, world::Side::Positive}) {
          inside += world::distance_to_defense_area(field, side, robot.position) < 0;
        }
      }
    }
  }
  // A robot pushed in by others may touch a ball there once in a while; wholly inside nobody goes by himself.
  EXPECT_LE(inside, 2);
}

// The kicker between two receivers that were worth the same turned to and fro and never kicked: in one
// kickoff of four the ten seconds were over.
TEST(ReferenceTeam, TakesItsKickoffAtOnce) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    Arena arena(reference_side(), reference_side(), seed);
    const Team team = seed % 2 == 0 ? Team::Yellow : Team::Blue;
    arena.tell({CommandKind::Kickoff, team});
    for (int i = 0; i < 5 * 60; ++i) arena.tick();
    arena.tell({CommandKind::Ready, team});
    // Turning to a side, going round the ball and kicking take about a second and a half.
    for (int i = 0; i < 3 * 60; ++i) arena.tick();
    EXPECT_GT(arena.engine().truth().ball.position.head<2>().norm(), 0.05) << "seed " << seed;
  }
}

TEST(ReferenceTeam, BeatsTheChaserInTwoMinutes) {
  Arena arena(reference_side(), chaser_side(), 6);
  arena.start_referee(std::chrono::seconds{60});
  while (arena.tick() && arena.engine().tick() < 60 * 240) {
  }
  const world::GameState& state = arena.referee()->state();
  EXPECT_EQ(state.stage, world::Stage::Post);
  EXPECT_GT(state.score.yellow, state.score.blue);
}

TEST(ReferenceTeam, PlaysTheSameGameTwice) {
  std::array<world::Vector3d, 2> ends;
  for (world::Vector3d& end : ends) {
    Arena arena(reference_side(), reference_side(), 7);
    arena.start_referee(std::chrono::seconds{20});
    for (int i = 0; i < 20 * 60; ++i) arena.tick();
    end = arena.engine().truth().ball.position;
  }
  EXPECT_EQ(ends[0], ends[1]);
}

}  // namespace

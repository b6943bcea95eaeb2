#include "experiments/statistics/observer.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sim/physics/ball.h"

namespace statistics {
namespace {

using record::MatchStatistics;
using record::TeamStatistics;
using world::Team;
using world::Vector2d;
using world::Vector3d;

const world::RobotId yellow1{Team::Yellow, 1};
const world::RobotId yellow2{Team::Yellow, 2};
const world::RobotId blue1{Team::Blue, 1};
const world::RobotId blue0{Team::Blue, 0};  // their keeper

/// A passage of play written down: yellow attacks the goal at +x, which blue 0 keeps.
class Passage {
 public:
  Passage() : observer_(world::Geometry{}) {
    state_.location = world::Location::GameOn;
    state_.blue_on_positive_half = true;
    place(blue0, {4.4, 0});
    place(blue1, {2, 2});
    place(yellow1, {0, 0});
    place(yellow2, {-1, 2});
    ball({0.1, 0});
  }

  Passage& place(world::RobotId id, Vector2d position) {
    for (truth::Robot& robot : frame_.robots) {
      if (robot.id == id) {
        robot.position = position;
        return *this;
      }
    }
    truth::Robot robot;
    robot.id = id;
    robot.position = position;
    frame_.robots.push_back(robot);
    return *this;
  }
  Passage& ball(Vector2d position, double height = 0.0215) {
    frame_.ball.position = {position.x(), position.y(), height};
    return *this;
  }
  Passage& location(world::Location location) {
    state_.location = location;
    return *this;
  }
  Passage& keeper(world::RobotId id) {
    state_.keeper[id.team] = id.number;
    return *this;
  }

  Passage& ticks(int count) {
    for (int i = 0; i < count; ++i) end_tick();
    return *this;
  }
  Passage& seconds(double length) { return ticks(static_cast<int>(length * world::ticks_per_second)); }

  /// In the coming tick, which also ends.
  Passage& touch(world::RobotId robot, double impulse = 0.1) {
    frame_.contacts.push_back({world::tick_time(tick_, 2), robot, frame_.ball.position, impulse});
    return ticks(1);
  }
  Passage& kick(world::RobotId robot, Vector3d velocity) {
    frame_.contacts.push_back({world::tick_time(tick_, 1), robot, frame_.ball.position, 0.01});
    frame_.kicks.push_back({world::tick_time(tick_, 1), robot, frame_.ball.position, velocity});
    return ticks(1);
  }

  MatchStatistics end() {
    observer_.finish();
    return observer_.result();
  }

 private:
  void end_tick() {
    frame_.tick = ++tick_;
    frame_.time = state_.time = world::tick_time(tick_);
    observer_.update(frame_, state_);
    frame_.contacts.clear();
    frame_.kicks.clear();
  }

  Observer observer_;
  truth::Frame frame_;
  world::GameState state_;
  std::int64_t tick_ = 0;
};

TEST(FreePath, ReachesAsFarAsTheBallOfThePhysicsRolls) {
  world::Geometry geometry;
  physics::BallParams ball;
  geometry.ball_slide_deceleration = ball.slide_deceleration;
  geometry.ball_roll_deceleration = ball.roll_deceleration;
  for (const double speed : {0.5, 2.0, 6.0}) {
    const FreePath path = free_path({{}, yellow1, {0, 0, 0.0215}, {speed, 0, 0}}, geometry);
    EXPECT_NEAR(path.reach, physics::rolling_distance(speed, ball), 1e-9) << speed;
  }
}

TEST(FreePath, OfAChipIsAParabola) {
  // 4 m/s along, 3 m/s up: 2 v / g = 0.6116 s in the air, 3^2 / 2 g = 0.4587 m high half way.
  const FreePath path = free_path({{}, yellow1, {0, 0, 0.0215}, {4, 0, 3}}, world::Geometry{});
  EXPECT_NEAR(path.flight, 4 * 6 / 9.81, 1e-12);
  EXPECT_NEAR(path.height(path.flight / 2, 0.0215), 0.0215 + 9 / (2 * 9.81), 1e-12);
  EXPECT_NEAR(path.height(path.flight, 0.0215), 0.0215, 1e-12);
  EXPECT_NEAR(path.height(path.flight + 1, 0.0215), 0.0215, 1e-12);
}

Aim aim(Vector2d from, Vector3d velocity) {
  const world::Geometry geometry;
  return aim_of(free_path({{}, yellow1, {from.x(), from.y(), 0.0215}, velocity}, geometry),
                world::Side::Positive, geometry);
}

TEST(Aim, IsOnTargetBetweenThePostsAndAShotUpTo30CentimetresBeside) {
  // From 1 m before the line straight along x: the place across is where it started. Posts at 0.5 m.
  EXPECT_TRUE(aim({3.5, 0.47}, {5, 0, 0}).on_target);
  EXPECT_FALSE(aim({3.5, 0.49}, {5, 0, 0}).on_target) << "the whole ball: 0.5 - 0.0215";
  EXPECT_TRUE(aim({3.5, 0.79}, {5, 0, 0}).shot);
  EXPECT_FALSE(aim({3.5, 0.81}, {5, 0, 0}).shot);
}

TEST(Aim, IsNoneBackwardsOrTooSlow) {
  EXPECT_FALSE(aim({3.5, 0}, {-5, 0, 0}).shot);
  EXPECT_FALSE(aim({0, 0}, {1, 0, 0}).shot) << "rests after 1.1 m";
  EXPECT_TRUE(aim({0, 0}, {3, 0, 0}).shot);
  EXPECT_FALSE(aim({0, 0}, {0, 5, 0}).shot);
}

TEST(Aim, IsNotOnTargetOverTheBar) {
  // Lands 2.45 m ahead; the bar is at 0.155 m.
  const Aim over = aim({3.0, 0}, {4, 0, 3});
  EXPECT_TRUE(over.shot);
  EXPECT_FALSE(over.on_target);
  EXPECT_TRUE(aim({1.5, 0}, {4, 0, 3}).on_target) << "landed before the line";
}

TEST(Observer, CountsAShotThatTheKeeperSaves) {
  const MatchStatistics game = Passage().keeper(blue0).kick(yellow1, {5, 0, 0}).ticks(40).touch(blue0).end();
  EXPECT_EQ(game.teams.yellow.kicks, 1);
  EXPECT_EQ(game.teams.yellow.shots, 1);
  EXPECT_EQ(game.teams.yellow.shots_on_target, 1);
  EXPECT_EQ(game.teams.yellow.passes, 0);
  EXPECT_EQ(game.teams.blue.saves, 1);
}

TEST(Observer, CountsNoSaveWhenAnotherRobotBlocksOrTheShotWasWide) {
  const MatchStatistics blocked =
      Passage().keeper(blue0).kick(yellow1, {5, 0, 0}).ticks(9).touch(blue1).end();
  EXPECT_EQ(blocked.teams.yellow.shots_on_target, 1);
  EXPECT_EQ(blocked.teams.blue.saves, 0);
  const MatchStatistics wide =
      Passage().keeper(blue0).kick(yellow1, {5, 0.7, 0}).ticks(40).touch(blue0).end();
  EXPECT_EQ(wide.teams.yellow.shots, 1);
  EXPECT_EQ(wide.teams.yellow.shots_on_target, 0);
  EXPECT_EQ(wide.teams.blue.saves, 0);
}

TEST(Observer, CountsAShotThatEndsPlay) {
  const MatchStatistics game =
      Passage().kick(yellow1, {5, 0, 0}).ticks(60).location(world::Location::GameOff).ticks(1).end();
  EXPECT_EQ(game.teams.yellow.shots_on_target, 1);
}

TEST(Observer, CallsAShotThatATeamMateReceivesAPass) {
  const MatchStatistics game = Passage().kick(yellow1, {5, 0, 0}).ticks(20).touch(yellow2).end();
  EXPECT_EQ(game.teams.yellow.shots, 0);
  EXPECT_EQ(game.teams.yellow.passes, 1);
  EXPECT_EQ(game.teams.yellow.passes_completed, 1);
}

TEST(Observer, CountsAPassTowardsATeamMateThatAnOpponentGets) {
  // Yellow 2 stands at (-1, 2), 2.24 m away; the free path goes through it.
  const MatchStatistics game = Passage().kick(yellow1, {-2, 4, 0}).ticks(20).touch(blue1).end();
  EXPECT_EQ(game.teams.yellow.passes, 1);
  EXPECT_EQ(game.teams.yellow.passes_completed, 0);
  const MatchStatistics lost =
      Passage().kick(yellow1, {-2, 4, 0}).ticks(20).location(world::Location::GameOff).ticks(1).end();
  EXPECT_EQ(lost.teams.yellow.passes, 1) << "also when nobody gets it";
}

TEST(Observer, CountsNoPassWhereNoTeamMateIs) {
  const MatchStatistics clearance = Passage().kick(yellow1, {-4, -4, 0}).ticks(20).touch(blue1).end();
  EXPECT_EQ(clearance.teams.yellow.passes, 0);
  const MatchStatistics short_one = Passage().kick(yellow1, {-0.4, 0.8, 0}).ticks(20).touch(blue1).end();
  EXPECT_EQ(short_one.teams.yellow.passes, 0) << "at rest after 0.9 m";
  const MatchStatistics to_oneself = Passage().kick(yellow1, {-2, 4, 0}).ticks(20).touch(yellow1).end();
  EXPECT_EQ(to_oneself.teams.yellow.passes, 0);
}

TEST(Observer, TakesTheKickersOwnContactsAfterAKickAsPartOfIt) {
  const MatchStatistics game =
      Passage().kick(yellow1, {-2, 4, 0}).touch(yellow1).ticks(20).touch(yellow2).end();
  EXPECT_EQ(game.teams.yellow.passes_completed, 1);
}

TEST(Observer, CountsKicksOfRestartsButNoneInAStoppage) {
  Passage passage;
  passage.location(world::Location::Setup).kick(yellow1, {-2, 4, 0}).ticks(2);
  passage.location(world::Location::GameOn).ticks(10).touch(yellow2).ticks(5);
  passage.location(world::Location::GameOff).ticks(1).kick(blue1, {1, 0, 0}).ticks(1);
  const MatchStatistics game = passage.end();
  EXPECT_EQ(game.teams.yellow.kicks, 1);
  EXPECT_EQ(game.teams.yellow.passes_completed, 1);
  EXPECT_EQ(game.teams.blue.kicks, 0);
}

TEST(Observer, CountsTouches50MillisecondsApart) {
  Passage passage;
  passage.touch(yellow1).touch(yellow1).touch(yellow1);  // 17 ms apart: one
  passage.ticks(5).touch(yellow1);                       // 100 ms later: another
  passage.touch(blue1).touch(yellow1);                   // others in between: each
  passage.ticks(5).touch(yellow1, 0.0009);               // too light
  const MatchStatistics game = passage.end();
  EXPECT_EQ(game.teams.yellow.touches, 3);
  EXPECT_EQ(game.teams.blue.touches, 1);
}

TEST(Observer, GivesPossessionToTheLastToucher) {
  const MatchStatistics game = Passage()
                                   .ticks(7)
                                   .touch(yellow1)
                                   .ticks(59)
                                   .touch(blue1)
                                   .ticks(29)
                                   .location(world::Location::GameOff)
                                   .ticks(60)
                                   .end();
  EXPECT_DOUBLE_EQ(game.teams.yellow.possession, 1.0);
  EXPECT_DOUBLE_EQ(game.teams.blue.possession, 0.5);
  EXPECT_NEAR(game.in_play, 97.0 / 60, 1e-12);
  EXPECT_NEAR(game.time, 157.0 / 60, 1e-12);
}

TEST(Observer, CountsABallAsLostWhenTheOthersKeepItHalfASecond) {
  Passage passage;
  passage.touch(yellow1).ticks(30).touch(blue1).ticks(10).touch(yellow1).ticks(30);  // won back after 0.2 s
  passage.touch(blue1).ticks(40).touch(blue1).ticks(40);                             // lost
  const MatchStatistics game = passage.end();
  EXPECT_EQ(game.teams.yellow.turnovers, 1);
  EXPECT_EQ(game.teams.blue.turnovers, 0);
}

TEST(Observer, MeasuresTerritoryByTheHalfTheBallIsIn) {
  const MatchStatistics game = Passage().ball({1, 0}).ticks(60).ball({-1, 0}).ticks(30).end();
  EXPECT_DOUBLE_EQ(game.teams.yellow.territory, 1.0) << "blue defends the goal at +x";
  EXPECT_DOUBLE_EQ(game.teams.blue.territory, 0.5);
}

TEST(Observer, CountsTheBallOutOncePerPassageAndNotInTheGoal) {
  Passage passage;
  passage.touch(yellow1).ball({0, 3.021}).ticks(1);
  EXPECT_EQ(passage.ball({0, 3.02}).ticks(1).end().teams.yellow.balls_out, 0) << "a bit of it is on the line";
  passage.ball({0, 3.03}).ticks(10).ball({0, 2}).ticks(1).ball({0, 3.5}).ticks(1);
  EXPECT_EQ(passage.end().teams.yellow.balls_out, 1);
  EXPECT_EQ(Passage().touch(yellow1).ball({4.6, 0.2}).ticks(5).end().teams.yellow.balls_out, 0);
  EXPECT_EQ(Passage().touch(yellow1).ball({4.6, 0.6}).ticks(5).end().teams.yellow.balls_out, 1);
  EXPECT_EQ(Passage().touch(yellow1).ball({4.6, 0.2}, 0.3).ticks(5).end().teams.yellow.balls_out, 1)
      << "over the bar";
}

TEST(Observer, MeasuresPassages) {
  Passage passage;
  passage.ticks(30).location(world::Location::GameOff).ticks(10);
  passage.location(world::Location::GameOn).ticks(90).location(world::Location::Setup).ticks(10);
  passage.location(world::Location::GameOn).ticks(60);
  const MatchStatistics game = passage.end();
  EXPECT_EQ(game.passages, 3);
  EXPECT_DOUBLE_EQ(game.longest_passage, 1.5);
  EXPECT_DOUBLE_EQ(game.in_play, 3.0);
}

TEST(Observer, MeasuresTheDistanceRunButNotRobotsThatArePutElsewhere) {
  Passage passage;
  passage.ticks(1);
  for (int i = 1; i <= 60; ++i) passage.place(yellow1, {0.05 * i, 0}).ticks(1);  // 3 m/s
  passage.place(yellow1, {-3, -3}).ticks(1);
  const MatchStatistics game = passage.end();
  EXPECT_NEAR(game.teams.yellow.distance, 3.0, 1e-12);
  EXPECT_EQ(game.teams.blue.distance, 0);
}

// The same passage with colours and ends exchanged gives the same numbers exchanged.
TEST(Observer, TreatsBothTeamsAlike) {
  const MatchStatistics here = Passage().keeper(blue0).kick(yellow1, {5, 0, 0}).ticks(40).touch(blue0).end();
  Passage mirrored;
  mirrored.keeper({Team::Yellow, 0}).ball({-0.1, 0}).kick(blue1, {-5, 0, 0}).ticks(40);
  const MatchStatistics there = mirrored.touch({Team::Yellow, 0}).end();
  EXPECT_EQ(here.teams.yellow.shots_on_target, there.teams.blue.shots_on_target);
  EXPECT_EQ(here.teams.blue.saves, there.teams.yellow.saves);
  EXPECT_EQ(here.teams.yellow.touches, there.teams.blue.touches);
  EXPECT_DOUBLE_EQ(here.teams.yellow.possession, there.teams.blue.possession);
  EXPECT_DOUBLE_EQ(here.teams.yellow.territory, there.teams.blue.territory);
}

}  // namespace
}  // namespace statistics

// What the scenarios cannot measure: instants, places and the smallest numbers of frames of single detectors.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "autoref/detectors/ball.h"
#include "autoref/detectors/catalogue.h"
#include "autoref/detectors/defender_in_area.h"
#include "autoref/detectors/double_touch.h"
#include "autoref/detectors/dribbled_too_far.h"
#include "autoref/detectors/interfered_placement.h"
#include "autoref/detectors/keeper_contact.h"
#include "autoref/detectors/keeper_held_ball.h"
#include "autoref/detectors/kick_taken.h"
#include "autoref/detectors/kicked_too_fast.h"
#include "autoref/detectors/no_progress.h"
#include "autoref/detectors/robot_left_field.h"
#include "autoref/detectors/robots_settled.h"
#include "tests/autoref/detectors/ways.h"

namespace detectors {
namespace {

using namespace std::chrono_literals;
using world::GameEvent;
using world::RobotId;
using world::Team;
using world::Time;
using world::TrackedFrame;
using world::Vector2d;

TEST(DribbledTooFar, ReportsTheInstantTheBallPassesOneMetre) {
  DribbledTooFar detector(rules());
  EXPECT_TRUE(along(detector, {0, 0}, {1, 0}, 99, true).empty());
  detector.reset();
  const auto events = along(detector, {-4.2, 2.7}, {1, 0}, 150, true);
  ASSERT_EQ(events.size(), 1u);
  EXPECT_NEAR(seconds_of(events[0]), 1.0, one_rounding);
  EXPECT_EQ(std::get<world::BotDribbledBallTooFar>(events[0].what).by, yellow_3);
}

TEST(DribbledTooFar, StartsAgainAfterAnObservableSeparationOnly) {
  for (const bool separates : {true, false}) {
    DribbledTooFar detector(rules());
    EXPECT_TRUE(along(detector, {0, 0}, {1, 0}, 90, true).empty());
    // The robot stays behind for two frames, or for one, which may be an error of the filter.
    for (int i = 1; i <= (separates ? 2 : 1); ++i) {
      TrackedFrame frame = frame_at(Time{1s + i * 10ms}, {0.9, 0});
      frame.robots[0].position.x() -= 0.04;  // 45.5 mm from hull to ball
      EXPECT_TRUE(detector.update(frame, world::GameState{}).empty());
    }
    EXPECT_EQ(along(detector, {0.9, 0}, {1, 0}, 90, true, Time{2s}).size(), separates ? 0u : 1u);
  }
}

TEST(DribbledTooFar, AHiddenBallPartsFromNobody) {
  DribbledTooFar detector(rules());
  int reported = 0;
  for (int i = 0; i <= 150; ++i) {
    TrackedFrame frame = frame_at(Time{i * 10ms}, {i * 0.01, 0}, true);
    frame.ball->observed = i < 10 || i > 110;
    if (i > 60 && i < 70) frame.ball->position.x() += 0.04;  // where it is only believed to be
    reported += static_cast<int>(detector.update(frame, world::GameState{}).size());
  }
  EXPECT_EQ(reported, 1);
}

TEST(DribbledTooFar, AHiddenBallThatAnotherRobotMayHaveTakenMustBeSeen) {
  for (const bool another : {true, false}) {
    DribbledTooFar detector(rules());
    std::optional<int> reported;
    for (int i = 0; i <= 150; ++i) {
      const Vector2d ball{i * 0.01, 0};
      TrackedFrame frame = frame_at(Time{i * 10ms}, ball, true);
      frame.ball->observed = i < 50 || i > 120;  // hidden while it passes 1 m
      if (another) {
        frame.robots.push_back(frame.robots[0]);
        frame.robots[1].id = {Team::Blue, 1};
        frame.robots[1].position = Vector2d{0.55, 0.13};  // 18.5 mm from hull to ball at 0.55 m
      }
      for (const GameEvent& event : detector.update(frame, world::GameState{})) {
        reported = i;
        EXPECT_NEAR(seconds_of(event), 1.0, one_rounding);  // whenever it is told
      }
    }
    EXPECT_EQ(reported, another ? 121 : 100);
  }
}

TEST(DribbledTooFar, MeasuresStraightFromTheStartNotAlongThePath) {
  DribbledTooFar detector(rules());
  // Two full circles of radius 0.4 m: a 5 m path that is never more than 0.8 m from its start.
  for (int i = 0; i <= 400; ++i) {
    const Vector2d ball = 0.4 * world::direction(i * 0.01 * 3.14159265);
    EXPECT_TRUE(detector.update(frame_at(Time{i * 10ms}, ball, true), world::GameState{}).empty());
  }
}

TEST(RobotLeftField, IsNotedAgainOnceTheRobotHasClearlyComeBack) {
  for (const double back_to : {0.2, 0.16}) {  // [m] outside the lines; 0.25 m are allowed
    RobotLeftField detector(rules());
    int noted = 0;
    for (int i = 0; i < 800; ++i) {
      TrackedFrame frame = frame_at(Time{i * 10ms}, {0, 0});
      const bool inside = i >= 300 && i < 400;
      frame.robots[0].observed = true;
      frame.robots[0].position = Vector2d{0, 3 + (inside ? back_to : 0.4)};
      noted += static_cast<int>(detector.update(frame, world::GameState{}).size());
    }
    EXPECT_EQ(noted, back_to < 0.17 ? 2 : 1);
  }
}

TEST(KickedTooFast, WantsMoreThanTwoFramesAndABall) {
  KickedTooFast detector(rules());
  along(detector, {0, 0}, {1, 0}, 3);
  EXPECT_TRUE(along(detector, {0, 0}, {9, 0}, 1, false, Time{100ms}).empty());
  const auto events = along(detector, {0.3, 0}, {9.5, 0}, 5, false, Time{130ms});
  ASSERT_EQ(events.size(), 1u);
  EXPECT_EQ(std::get<world::BotKickedBallTooFast>(events[0].what).by, yellow_3);
  EXPECT_TRUE(along(detector, {1, 0}, {14, 0}, 20, false, Time{200ms}).empty());  // no ball
}

// A hopping ball is projected to other places by each camera: fast to and fro, and nowhere.
TEST(KickedTooFast, WantsTheBallToGetSomewhere) {
  KickedTooFast detector(rules());
  along(detector, {0, 0}, {1, 0}, 3);
  for (int i = 0; i < 20; ++i) {
    TrackedFrame frame = frame_at(Time{100ms + i * 10ms}, {i % 2 == 0 ? 0.0 : 0.09, 0});
    frame.ball->velocity.x() = i % 2 == 0 ? -9.0 : 9.0;
    EXPECT_TRUE(detector.update(frame, world::GameState{}).empty());
  }
}

TEST(KickTaken, IsTheInstantAtFiftyMillimetres) {
  KickTaken detector(rules());
  world::GameState state;
  state.kick_position = Vector2d{0, 0};
  std::vector<GameEvent> events;
  for (int i = 1; i < 40; ++i) {  // 0.3 m/s: slower than a kick known by its speed
    TrackedFrame frame = frame_at(Time{i * 10ms}, {0.003 * i, 0});
    frame.ball->velocity.x() = 0.3;
    for (GameEvent& event : detector.update(frame, state)) events.push_back(event);
  }
  ASSERT_EQ(events.size(), 1u);
  EXPECT_NEAR(seconds_of(events[0]), 0.05 / 0.3, 1e-6);
  EXPECT_EQ(std::get<world::KickTaken>(events[0].what).by, yellow_3);
}

TEST(KickTaken, KnowsWhenAnOpponentIsNearASecondTime) {
  KickTaken detector(rules());
  world::GameState state;
  state.kick_team = Team::Blue;  // the robot of the frames is an opponent, at the ball
  state.kick_position = Vector2d{0, 0};
  const auto attempt = [&](Vector2d place) {
    detector.reset();
    state.kick_position = place;
    std::optional<world::KickTaken> kick;
    for (int i = 1; i < 20; ++i) {
      const TrackedFrame frame = frame_at(Time{i * 10ms}, place + Vector2d{0.01 * i, 0});
      for (const GameEvent& event : detector.update(frame, state))
        kick = std::get<world::KickTaken>(event.what);
    }
    return kick.value().again;
  };
  EXPECT_FALSE(attempt({0, 0}));
  EXPECT_TRUE(attempt({0.02, 0}));
  EXPECT_TRUE(attempt({0, 0}));
  EXPECT_FALSE(attempt({1, 0}));  // another kick
  state.is_kickoff = true;        // Law 12, caution 5, does not name the kickoff
  EXPECT_FALSE(attempt({1, 0}));
}

TEST(NoProgress, WantsTwelveSecondsAndReportsOncePerWait) {
  NoProgress detector(rules());
  EXPECT_TRUE(along(detector, {0, 0}, {0, 0}, 1199).empty());
  detector.reset();
  EXPECT_EQ(along(detector, {0, 0}, {0, 0}, 2399).size(), 1u);
  detector.reset();
  EXPECT_TRUE(along(detector, {-3, 0}, {0.26, 0}, 2400).empty());  // just over 0.25 m in each second
}

TEST(NoProgress, CountsAnySecondNotOnlyWholeOnes) {
  NoProgress detector(rules());
  // 0.3 m around the end of every other second, 0.15 m on either side.
  for (int i = 0; i < 2400; ++i) {
    const int phase = (i + 35) % 200;
    const double x = 0.3 * (i + 35 - phase) / 200.0 + 0.3 * std::clamp((phase - 120) / 30.0, 0.0, 1.0);
    EXPECT_TRUE(detector.update(frame_at(Time{i * 10ms}, {x - 2, 0}), world::GameState{}).empty()) << i;
  }
}

TEST(NoProgress, KnowsThatAHiddenBallGoesAlongWithARobot) {
  // Carried at 0.3 m/s, seen for a moment every two seconds only, as by a slow robot with
  // its back to the camera.
  for (const bool carried : {true, false}) {
    NoProgress detector(rules());
    std::size_t events = 0;
    for (int i = 0; i < 2000; ++i) {
      TrackedFrame frame = frame_at(Time{i * 10ms}, {-3 + 0.003 * i, 0});
      frame.ball->observed = i == 0;
      frame.robots[0].ball_in_reach = carried;
      events += detector.update(frame, world::GameState{}).size();
    }
    EXPECT_EQ(events, carried ? 0u : 1u);  // nobody has it: what is foretold for it is no progress
  }
}

TEST(DefenderInArea, CarriesTheBallBesideItsGoalieButNotBesideAnOpponent) {
  // Hidden, at 0.3 m/s, another robot's hull 20 mm from the ball: that may be the goalie, which stands there
  // as a rule. An opponent so near may have it.
  for (const bool goalie : {true, false}) {
    DefenderInArea detector(rules());
    const world::GameState state;
    const double own = world::sign(world::defended_side(state, Team::Yellow));
    std::size_t events = 0;
    for (int i = 0; i < 20; ++i) {
      const Vector2d ball(own * 4.1, 0.003 * i);
      TrackedFrame frame = frame_at(Time{i * 10ms}, ball, true);
      frame.ball->observed = false;
      frame.ball->unseen = 100ms + i * 10ms;
      frame.ball->velocity.y() = 0.3;
      frame.robots[0].position = ball - Vector2d(0.0945, 0);  // yellow 3, at its front
      frame.robots[0].velocity = {0, 0.3};
      world::TrackedRobot other;
      other.id = goalie ? RobotId{Team::Yellow, static_cast<std::uint8_t>(state.keeper[Team::Yellow])}
                        : RobotId{Team::Blue, 2};
      other.position = ball + Vector2d(0.09 + 0.0215 + 0.02, 0);
      other.orientation = 0;  // its back to the ball
      frame.robots.push_back(other);
      events += detector.update(frame, state).size();
    }
    EXPECT_EQ(events, goalie ? 1u : 0u);
  }
}

TEST(DefenderInArea, TouchesABallThatItPressesAgainstItsGoalie) {
  // A ball at rest, hidden; yellow 3 comes on at 0.5 m/s and stops 5 mm before the place where the ball is
  // believed. With the goalie behind the ball there is no room; with the goalie 30 mm away, or on the same
  // side, the ball may lie free.
  enum class Goalie { Behind, Away, Beside };
  for (const Goalie goalie : {Goalie::Behind, Goalie::Away, Goalie::Beside}) {
    DefenderInArea detector(rules());
    const world::GameState state;
    const double own = world::sign(world::defended_side(state, Team::Yellow));
    const Vector2d ball(own * 4.1, 0);
    std::vector<GameEvent> events;
    for (int i = 0; i < 300; ++i) {
      TrackedFrame frame = frame_at(Time{i * 10ms}, ball);
      frame.ball->observed = false;
      frame.ball->unseen = 100ms + i * 10ms;
      const double gap = std::max(0.005, 0.05 - 0.005 * i);  // within 20 mm at 60 ms, within 10 mm at 80 ms
      frame.robots[0].position = ball - Vector2d(0.073 + 0.0215 + gap, 0);
      world::TrackedRobot other;
      other.id = {Team::Yellow, static_cast<std::uint8_t>(state.keeper[Team::Yellow])};
      const double way = 0.09 + 0.0215 + (goalie == Goalie::Away ? 0.03 : 0.001);
      const double angle = goalie == Goalie::Beside ? 2.2 : 0.0;  // against yellow 3, at pi
      other.position = ball + way * world::direction(angle);
      other.orientation = angle;  // its back to the ball
      frame.robots.push_back(other);
      for (GameEvent& event : detector.update(frame, state)) events.push_back(event);
    }
    ASSERT_EQ(events.size(), goalie == Goalie::Behind ? 1u : 0u);  // one that goes on is one
    if (!events.empty()) {
      EXPECT_EQ(events[0].time, Time{60ms});
    }
  }
}

TEST(KeeperContact, SumsUpTheFramesOfHullsThatBounce) {
  // 0.5 mm, then 10 mm apart, and again; or 3 mm all the time.
  for (const bool touches : {true, false}) {
    KeeperContact detector(rules());
    const world::GameState state;
    const double own = world::sign(world::defended_side(state, Team::Blue));
    std::size_t events = 0;
    for (int i = 0; i < 60; ++i) {
      TrackedFrame frame = frame_at(Time{i * 10ms}, {0, 0});
      const double gap = !touches ? 0.003 : i % 20 == 10 ? 0.0005 : 0.01;
      frame.robots[0].position = {own * 4.0, 0};
      world::TrackedRobot goalie;
      goalie.id = {Team::Blue, static_cast<std::uint8_t>(state.keeper[Team::Blue])};
      goalie.position = {own * 4.0, 0.18 + gap};
      frame.robots.push_back(goalie);
      for (world::TrackedRobot& robot : frame.robots) robot.observed = true;
      events += detector.update(frame, state).size();
    }
    EXPECT_EQ(events, touches ? 1u : 0u);
  }
}

TEST(InterferedPlacement, BeginsWithAHiddenBallButDoesNotEndWithIt) {
  // Hidden for the first second, as where it was taken out; a robot on its way. In the middle it is believed
  // elsewhere for a moment, which frees nobody; that the ball is seen elsewhere does.
  for (const bool seen : {false, true}) {
    InterferedPlacement detector(rules());
    world::GameState state;
    state.location = world::Location::GameOff;
    state.command.kind = world::CommandKind::Stop;
    state.reset_position = Vector2d{2, 0};
    std::size_t events = 0;
    for (int i = 0; i <= 210; ++i) {
      const bool elsewhere = i >= 50 && i < 60;
      TrackedFrame frame = frame_at(Time{i * 10ms}, {elsewhere ? 2.6 : 0.0, 0});
      frame.robots[0].position = {1, 0.3};
      frame.ball->observed = i >= 100 || (elsewhere && seen);
      events += detector.update(frame, state).size();
    }
    EXPECT_EQ(events, seen ? 0u : 1u);
  }
}

TEST(KeeperHeldBall, WantsTheBallAtItsHull) {
  // 25 mm before the front is not held (the truth's limit is 5 mm); 25 mm may be, if nobody sees it.
  for (const bool observed : {true, false}) {
    for (const double gap : {0.005, 0.025}) {
      KeeperHeldBall detector(rules());
      world::GameState state;
      std::size_t events = 0;
      for (int i = 0; i < 1600; ++i) {
        TrackedFrame frame = frame_at(Time{i * 10ms}, {0, 0});
        world::TrackedRobot& keeper = frame.robots[0];
        const double own = world::sign(world::defended_side(state, keeper.id.team));
        keeper.id.number = static_cast<std::uint8_t>(state.keeper[keeper.id.team]);
        keeper.position = {4.2 * own, 0};
        keeper.orientation = 0;
        frame.ball->position.head<2>() = keeper.position + Vector2d(0.073 + 0.0215 + gap, 0);
        frame.ball->observed = observed;
        events += detector.update(frame, state).size();
      }
      EXPECT_EQ(events, gap < 0.01 || !observed ? 1u : 0u) << gap << observed;
    }
  }
}

TEST(KickedTooFast, MeasuresTheWayOfASlidingBall) {
  // Kicked out of rest, sliding with 3 m/s^2; the frames are those of 60 images a second.
  const auto kick = [](double speed, int frames) {
    KickedTooFast detector(rules());
    std::vector<GameEvent> all;
    for (int i = -5; i <= frames; ++i) {
      const double t = std::max(0, i) / 60.0;
      TrackedFrame frame = frame_at(Time{1s + i * 16667us}, {speed * t - 1.5 * t * t, 0});
      frame.robots[0].position = {-0.1, 0};
      frame.ball->velocity.x() = i > 0 ? speed - 3 * t : 0;
      for (GameEvent& event : detector.update(frame, world::GameState{})) all.push_back(event);
    }
    return all;
  };
  EXPECT_TRUE(kick(8.0, 30).empty());
  EXPECT_TRUE(kick(8.1, 30).empty());    // 10 mm farther in 0.1 s: in doubt
  EXPECT_EQ(kick(8.25, 30).size(), 1u);  // 25 mm
  EXPECT_EQ(kick(10, 2).size(), 1u);     // 33 mm farther in two frames
  EXPECT_TRUE(kick(10, 1).empty());      // I-30: not from one
  EXPECT_EQ(std::get<world::BotKickedBallTooFast>(kick(9, 10)[0].what).by, yellow_3);
}

TEST(KickedTooFast, KnowsTheKickOfARestartThatItNeverSawAtRest) {
  KickedTooFast detector(rules());
  world::GameState state;
  state.kicker = yellow_3;
  state.kick_position = Vector2d{0, 0};
  std::vector<GameEvent> all;
  for (int i = 2; i <= 8; ++i) {  // play began with the kick, two frames ago
    const double t = i / 60.0;
    TrackedFrame frame = frame_at(Time{i * 16667us}, {9 * t - 1.5 * t * t, 0});
    frame.ball->velocity.x() = 9 - 3 * t;
    for (GameEvent& event : detector.update(frame, state)) all.push_back(event);
  }
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(std::get<world::BotKickedBallTooFast>(all[0].what).by, yellow_3);
}

TEST(DoubleTouch, SeesTheKickerCarryAHiddenBall) {
  for (const bool turns_away : {true, false}) {
    DoubleTouch detector(rules());
    world::GameState state;
    state.kicker = yellow_3;
    state.kick_position = Vector2d{0, 0};
    std::size_t told = 0;
    for (int i = 0; i < 60; ++i) {
      // Tapped 0.2 m away; the kicker is 45 mm behind the ball, then has it, hidden, and drives on at 1 m/s.
      const bool there = i >= 20 && !turns_away;
      TrackedFrame frame = frame_at(Time{i * 16667us}, {0.2 + i / 60.0, 0}, there);
      frame.ball->velocity.x() = 1;
      frame.ball->observed = !there;
      frame.robots[0].velocity.x() = 1;
      if (!there) frame.robots[0].position.x() -= 0.04;
      told += detector.update(frame, state).size();
    }
    EXPECT_EQ(told, turns_away ? 0u : 1u);
  }
}

TEST(KickTaken, IsNotAHiccupOfTheFilter) {
  // Recorded at a centre mark, where four cameras meet: a ball at rest that read 11 and 15 mm away at 1 m/s.
  KickTaken detector(rules());
  world::GameState state;
  state.kick_position = Vector2d{0, 0};
  const std::array<std::pair<double, double>, 7> read = {
      {{0.001, 0}, {0.005, 0.43}, {0.011, 0.81}, {0.013, 0.97}, {0.015, 1.16}, {0.009, 0.33}, {0.001, 0}}};
  int n = 0;
  for (const auto& [place, speed] : read) {
    TrackedFrame frame = frame_at(Time{++n * 16667us}, {place, 0});
    frame.ball->velocity.x() = speed;
    EXPECT_TRUE(detector.update(frame, state).empty()) << n;
  }
}

TEST(RobotsSettled, NeedsOneQuietSecondAndTheBallInPlace) {
  RobotsSettled detector(rules());
  world::GameState state;
  state.reset_position = Vector2d{1, 1};
  int fired_at = -1;
  for (int i = 0; i < 400 && fired_at < 0; ++i) {
    TrackedFrame frame = frame_at(Time{i * 10ms}, i < 50 ? Vector2d{1.06, 1} : Vector2d{1.04, 1});
    if (i > 60) frame.robots[0].position.x() += 0.41 * 0.01 * (std::min(i, 100) - 60);
    if (i > 60 && i <= 100) frame.robots[0].velocity = {0.41, 0};
    if (i == 120) frame.robots[0].velocity = {2, 0};  // what a filter says for an instant, and nothing moves
    if (!detector.update(frame, state).empty()) fired_at = i;
  }
  EXPECT_EQ(fired_at, 200);  // one second after the robot last moved, in frame 100
}

TEST(RobotsSettled, GivesUpWaitingAfterFifteenSeconds) {
  RobotsSettled detector(rules());
  int fired_at = -1;
  for (int i = 0; i < 2000 && fired_at < 0; ++i) {
    TrackedFrame frame = frame_at(Time{i * 10ms}, {0, 0});
    frame.robots[0].position.x() += 0.01 * i;
    frame.robots[0].velocity = {1, 0};
    const auto events = detector.update(frame, world::GameState{});
    if (events.empty()) continue;
    fired_at = i;
    EXPECT_TRUE(std::get<world::RobotsSettled>(events[0].what).waited_too_long);
  }
  EXPECT_EQ(fired_at, 1500);
}

TEST(Catalogue, RunsEachDetectorOnlyWhereItApplies) {
  Detectors all(rules());
  world::GameState state;
  state.location = world::Location::Break;
  for (int i = 0; i < 2000; ++i) EXPECT_TRUE(all.update(frame_at(Time{i * 10ms}, {0, 4}), state).empty());
  EXPECT_EQ(catalogue().size(), 21u);
}

}  // namespace
}  // namespace detectors

// What the scenarios cannot measure of the offences: speeds, times, blame, and the
// catalogue against rule sets.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "autoref/automaton/occurrence.h"
#include "autoref/detectors/catalogue.h"
#include "autoref/detectors/chipped_goal.h"
#include "autoref/detectors/collision.h"
#include "autoref/detectors/defender_in_area.h"
#include "autoref/detectors/robot_past.h"
#include "autoref/detectors/too_fast_in_stop.h"
#include "autoref/detectors/too_many_robots.h"

namespace detectors {
namespace {

using namespace std::chrono_literals;
using world::GameEvent;
using world::RobotId;
using world::Team;
using world::Time;
using world::TrackedFrame;
using world::TrackedRobot;
using world::Vector2d;

constexpr RobotId yellow_3{Team::Yellow, 3};
constexpr RobotId blue_5{Team::Blue, 5};

const world::RuleSet& rules() { return world::rule_set("ssl-2015"); }

TrackedRobot robot_at(RobotId id, Vector2d position, Vector2d velocity = Vector2d::Zero()) {
  TrackedRobot robot;
  robot.id = id;
  robot.position = position;
  robot.velocity = velocity;
  robot.observed = true;
  return robot;
}

TrackedFrame frame_at(Time time, std::vector<TrackedRobot> robots) {
  TrackedFrame frame;
  frame.time = time;
  frame.robots = std::move(robots);
  return frame;
}

// Two robots on straight ways, one frame every 10 ms; without `aside` they touch at 0.5 s.
std::vector<GameEvent> crash(Vector2d yellow_velocity, Vector2d blue_velocity, double aside = 0) {
  Collision detector(rules());
  std::vector<GameEvent> all;
  for (int i = 0; i <= 60; ++i) {
    const double left = 0.5 - i * 0.01;
    const TrackedRobot yellow =
        robot_at(yellow_3, Vector2d{-0.09, 0} - yellow_velocity * left, yellow_velocity);
    const TrackedRobot blue = robot_at(blue_5, Vector2d{0.09, aside} - blue_velocity * left, blue_velocity);
    for (GameEvent& event : detector.update(frame_at(Time{i * 10ms}, {yellow, blue}), world::GameState{})) {
      all.push_back(event);
    }
  }
  return all;
}

TEST(Collision, ComparesTheClosingSpeedWithTheLimitAndTheBraking) {
  EXPECT_TRUE(crash({1.59, 0}, {0, 0}).empty());
  const auto events = crash({1.61, 0}, {0, 0});
  ASSERT_EQ(events.size(), 1u);
  const auto& crash_ = std::get<world::BotCrashUnique>(events[0].what);
  EXPECT_EQ(crash_.by, yellow_3);
  EXPECT_EQ(crash_.victim, blue_5);
  EXPECT_NEAR(crash_.speed, 1.61, 1e-9);
}

TEST(Collision, MeasuresAlongTheLineBetweenTheRobots) {
  // 0.15 m aside at a reach of 0.18 m: the line is turned by asin(0.15 / 0.18), cosine 0.553.
  EXPECT_TRUE(crash({2.8, 0}, {0, 0}, 0.15).empty());
  EXPECT_FALSE(crash({3.4, 0}, {0, 0}, 0.15).empty());
  EXPECT_TRUE(crash({3.4, 0}, {0, 0}, 0.185).empty());  // passes by
}

TEST(Collision, BlamesTheFasterPartOrBoth) {
  const auto blue = crash({0.8, 0}, {-1.2, 0});
  ASSERT_EQ(blue.size(), 1u);
  EXPECT_EQ(std::get<world::BotCrashUnique>(blue[0].what).by, blue_5);
  const auto both = crash({1.0, 0}, {-1.25, 0});
  ASSERT_EQ(both.size(), 1u);
  EXPECT_NEAR(std::get<world::BotCrashDrawn>(both[0].what).speed_difference, 0.25, 1e-9);
  const auto from_behind = crash({3.0, 0}, {0.5, 0});
  ASSERT_EQ(from_behind.size(), 1u);
  EXPECT_EQ(std::get<world::BotCrashUnique>(from_behind[0].what).by, yellow_3);
}

TEST(Collision, DoesNotBelieveAVelocityThatThePlacesDoNotShow) {
  Collision detector(rules());
  for (int i = 0; i <= 60; ++i) {  // a robot that stands, its velocity wrong in the last frames
    const Vector2d place{i < 60 ? -0.2 : -0.18, 0};
    const TrackedRobot yellow = robot_at(yellow_3, place, {i > 57 ? 3.0 : 0.0, 0});
    const auto events =
        detector.update(frame_at(Time{i * 10ms}, {yellow, robot_at(blue_5, {0, 0})}), world::GameState{});
    EXPECT_TRUE(events.empty());
  }
}

TEST(RobotPast, InterpolatesAndForgets) {
  RobotPast past;
  for (int i = 0; i < 100; ++i) past.add(frame_at(Time{i * 10ms}, {robot_at(yellow_3, {0.01 * i, 0})}));
  EXPECT_NEAR(past.position(yellow_3, Time{955ms})->x(), 0.955, 1e-12);
  EXPECT_NEAR(past.position(yellow_3, Time{2s})->x(), 0.99, 1e-12);
  EXPECT_FALSE(past.position(yellow_3, Time{500ms}));
  EXPECT_FALSE(past.position(blue_5, Time{955ms}));
}

TEST(DefenderInArea, UsesTheRobotsPlaceAtTheTouchAndOnlySureTouches) {
  for (const double probability : {0.7, 0.9}) {
    DefenderInArea detector(rules());
    std::vector<GameEvent> all;
    for (int i = 0; i <= 20; ++i) {  // out of the area at 3 m/s; wholly inside until 0.11 s
      TrackedFrame frame = frame_at(Time{i * 10ms}, {robot_at({Team::Yellow, 4}, {-3.9 + 0.03 * i, 0})});
      if (i == 20) {
        frame.touches.push_back({{Team::Yellow, 4}, Time{100ms}, {-3.5, 0}, probability, std::nullopt});
      }
      for (GameEvent& event : detector.update(frame, world::GameState{})) all.push_back(event);
    }
    ASSERT_EQ(all.size(), probability > 0.8 ? 1u : 0u);
    if (all.empty()) continue;
    const auto& touch = std::get<world::DefenderInDefenseArea>(all[0].what);
    EXPECT_FALSE(touch.wholly);                    // the hull from -3.69 to -3.51, the area's edge at -3.5
    EXPECT_NEAR(touch.location.x(), -3.6, 1e-12);  // not -3.3
  }
}

TEST(TooFastInStop, GivesGraceAndReportsARobotOnce) {
  TooFastInStop detector(rules());
  world::GameState state;
  state.command.kind = world::CommandKind::Stop;
  std::vector<GameEvent> all;
  for (int i = 0; i <= 600; ++i) {
    const bool fast = i < 210 || (i > 300 && i < 325) || i > 400;  // in the grace, for 0.25 s, for long
    const TrackedFrame frame =
        frame_at(Time{i * 10ms}, {robot_at(yellow_3, {0, 0}, {fast ? 1.65 : 1.55, 0})});
    for (GameEvent& event : detector.update(frame, state)) all.push_back(event);
  }
  ASSERT_EQ(all.size(), 1u);
  EXPECT_NEAR(world::seconds(all[0].time), 4.01 + 0.3, 0.011);  // one frame
}

TEST(TooManyRobots, CountsCardsAndIgnoresMisreadNumbers) {
  for (const bool card : {false, true}) {
    TooManyRobots detector(rules());
    world::GameState state;
    if (card) state.yellow_times.yellow.push_back(60s);
    std::vector<GameEvent> all;
    for (int i = 0; i < 500; ++i) {
      std::vector<TrackedRobot> robots;
      for (std::uint8_t number = 0; number < 6; ++number) {
        robots.push_back(robot_at({Team::Yellow, number}, {0.3 * number, 0}));
      }
      // Misread for two images every 0.7 s, as another number each time.
      if (i % 70 < 2) robots[5].id.number = static_cast<std::uint8_t>(6 + i / 70);
      for (GameEvent& event : detector.update(frame_at(Time{i * 10ms}, robots), state)) all.push_back(event);
    }
    ASSERT_EQ(all.size(), card ? 1u : 0u);
  }
}

// A chip by yellow 3, deflected by blue 5 so that it rises again and goes into yellow's own goal: decision 7.
TEST(ChippedGoal, ADeflectionThatRisesIsTheDeflectorsChip) {
  for (const double after : {0.05, 0.4}) {
    ChippedGoal detector(rules());
    world::GameState state;
    state.last_touch = world::Touch{yellow_3, Time{0ms}, {-3, 0}, 1, std::nullopt};
    std::vector<GameEvent> all;
    for (int i = 0; i <= 120; ++i) {
      TrackedFrame frame;
      frame.time = Time{i * 10ms};
      if (i == 40) state.last_touch = world::Touch{blue_5, frame.time, {-3.4, 0}, 1, std::nullopt};
      world::TrackedBall ball;
      ball.observed = true;
      const double x = i < 40 ? -3 - 0.01 * i : std::max(-4.65, -3.4 - 0.03 * (i - 40));
      const double height = i < 40 ? 0.3 : std::max(0.0, after - 0.05 * std::max(0, i - 66));
      const bool flying = x > -4.4;
      ball.position = {x, 0, flying ? height : 0};
      if (flying) {
        ball.airborne = 1;
        ball.flight.emplace();
        ball.flight->kicked = Time{i < 40 ? 0ms : 400ms};
        ball.flight->from = {-3, 0};
        ball.flight->highest = i < 40 ? 0.3 : after;
      }
      frame.ball = ball;
      for (GameEvent& event : detector.update(frame, state)) all.push_back(event);
    }
    ASSERT_EQ(all.size(), after > 0.15 ? 1u : 0u);
    if (!all.empty()) {
      EXPECT_EQ(std::get<world::ChippedGoal>(all[0].what).by, blue_5);
    }
  }
}

// A shot at 4 m/s by yellow 3 that the filter took for a chip in its first frames, or that is one; `change`
// edits each frame.
std::vector<GameEvent> shot(const std::function<void(int, world::TrackedBall&)>& change,
                            std::optional<world::Touch> touch_at_20 = std::nullopt) {
  ChippedGoal detector(rules());
  world::GameState state;
  state.last_touch = world::Touch{yellow_3, Time{0ms}, {2.4, 0}, 1, std::nullopt};
  std::vector<GameEvent> all;
  for (int i = 0; i <= 80; ++i) {
    if (i == 20 && touch_at_20) state.last_touch = touch_at_20;
    TrackedFrame frame;
    frame.time = Time{i * 10ms};
    world::TrackedBall ball;
    ball.observed = true;
    ball.position = {std::min(4.65, 2.4 + 0.04 * i), 0, 0};
    change(i, ball);
    frame.ball = ball;
    for (GameEvent& event : detector.update(frame, state)) all.push_back(event);
  }
  return all;
}

// On the way up to 0.46 m at 3 m/s and down again, for 0.61 s.
void fly(int i, world::TrackedBall& ball, double airborne) {
  const double since = i * 0.01;
  const double height = 3 * since - 9.81 / 2 * since * since;
  if (height < 0) return;
  ball.airborne = airborne;
  ball.position.z() = i < 52 ? height : 0.05;
  ball.flight.emplace();
  ball.flight->launch_velocity = {4, 0, 3};
  ball.flight->highest = std::max(height, 0.4);
}

// A goal costs more than a chip goal that counts: flat kicks of 6 m/s look like chips in a frame or two.
TEST(ChippedGoal, AFlightThatIsTakenBackSpoilsNoGoal) {
  EXPECT_TRUE(shot([](int i, world::TrackedBall& ball) {
                if (i >= 8 && i < 12) fly(i, ball, 0.8);
              }).empty());
  EXPECT_EQ(shot([](int i, world::TrackedBall& ball) {
              if (i >= 8) fly(i, ball, i < 12 ? 0.8 : 0.99);
            }).size(),
            1u);
}

// At 0.2 s the ball is 0.4 m high: whoever is said to have touched it then, nobody did.
TEST(ChippedGoal, ARobotBelowTheBallHasNotTouchedIt) {
  const world::Touch below{blue_5, Time{200ms}, {3.2, 0}, 0.9, std::nullopt};
  const auto all = shot([](int i, world::TrackedBall& ball) { fly(i, ball, 1); }, below);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(std::get<world::ChippedGoal>(all[0].what).by, yellow_3);
}

// "Stopped bouncing": after a flight that ended on the ground 45 ms are enough, after one that was lost low
// above it they are not.
TEST(ChippedGoal, ABallThatRollsAfterItsFlightMakesAGoal) {
  for (const double last_height : {0.005, 0.08}) {
    const auto all = shot([&](int i, world::TrackedBall& ball) {
      if (i >= 45) return;  // 0.07 s before the line
      fly(i, ball, 1);
      if (i > 36) ball.position.z() = last_height + 0.05 * (44 - i);
    });
    EXPECT_EQ(all.size(), last_height < 0.03 ? 0u : 1u);
  }
}

// Law 12: what each offence leads to.
TEST(FoulOf, FollowsTheLaws) {
  using automaton::Card;
  using automaton::Severity;
  const Vector2d here{0, 0};
  const auto foul = [](decltype(GameEvent::what) what) { return automaton::foul_of({Time{}, what}); };
  const auto expect = [](const std::optional<automaton::Foul>& is, Severity severity, Card card) {
    ASSERT_TRUE(is);
    EXPECT_EQ(is->severity, severity);
    EXPECT_EQ(is->card, card);
    EXPECT_EQ(is->by, yellow_3);
  };
  expect(foul(world::AimlessKick{yellow_3, here, here}), Severity::Minor, Card::None);
  expect(foul(world::ChippedGoal{yellow_3, here, here, 0.3}), Severity::Minor, Card::None);
  expect(foul(world::AttackerTouchedKeeper{yellow_3, blue_5, here}), Severity::Minor, Card::None);
  expect(foul(world::AttackerTouchedBallInDefenseArea{yellow_3, here, here, 0.1}), Severity::Minor,
         Card::None);
  expect(foul(world::KeeperHeldBall{yellow_3, here, 15s}), Severity::Minor, Card::None);
  expect(foul(world::DefenderInDefenseArea{yellow_3, here, 0.1, false}), Severity::Minor, Card::Yellow);
  expect(foul(world::DefenderInDefenseArea{yellow_3, here, 0.3, true}), Severity::Serious, Card::None);
  expect(foul(world::BotTooFastInStop{yellow_3, here, 2}), Severity::Minor, Card::Yellow);
  world::BotCrashUnique collision;
  collision.by = yellow_3;
  expect(foul(collision), Severity::Serious, Card::None);
  collision.advantage = true;
  EXPECT_FALSE(foul(collision));
  world::KickTaken kick;
  kick.opponent_near_ball = yellow_3;
  EXPECT_FALSE(foul(kick));  // taken again
  kick.again = true;
  expect(foul(kick), Severity::Minor, Card::Yellow);
  EXPECT_FALSE(foul(world::BotCrashDrawn{}));
  EXPECT_FALSE(foul(world::BotTooNearInStop{yellow_3, here, 0.3}));
  EXPECT_FALSE(foul(world::BotInterferedPlacement{yellow_3, here}));
  EXPECT_FALSE(foul(world::BotLeftField{yellow_3, here, 0.3}));
  EXPECT_FALSE(foul(world::TooManyRobots{Team::Yellow, 7, 6}));
}

TEST(Catalogue, HasEveryDetectorThatARuleSetNames) {
  for (const std::string_view name : world::rule_set_names()) {
    EXPECT_NO_THROW(Detectors{world::rule_set(name)}) << name;
  }
  EXPECT_EQ(world::rule_set("ssl-2015").detectors.size(), catalogue().size());
  EXPECT_EQ(world::rule_set("paper").detectors.size(), 9u);
  world::RuleSet wrong = rules();
  wrong.detectors.push_back("ofside");
  try {
    const Detectors detectors(wrong);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("'ofside'"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace detectors

#include "sim/engine/engine.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <iostream>

#include "sim/world/random.h"

namespace {

using engine::Engine;
using engine::Model;
using world::Team;
using world::Vector2d;
using Commands = world::PerTeam<world::TeamCommands>;

Model six_a_side(std::string_view realism = "none", std::uint64_t seed = 1) {
  Model model;
  for (const Team team : world::both_teams) {
    model.robots[team] = engine::standard_robots(team, {0, 1, 2, 3, 4, 5});
  }
  model.realism = engine::realism(realism);
  model.seed = seed;
  return model;
}

const truth::Robot& find(const Engine& engine, Team team, int number) {
  for (const truth::Robot& robot : engine.truth().robots) {
    if (robot.id == world::RobotId{team, static_cast<std::uint8_t>(number)}) return robot;
  }
  throw std::runtime_error("no such robot");
}

world::RobotCommand forward(int number, double speed) {
  world::RobotCommand command;
  command.number = static_cast<std::uint8_t>(number);
  command.velocity_local = {speed, 0};
  return command;
}

TEST(Engine, BeginsWithALineUpAndTheBallAtTheCentre) {
  for (const bool blue_positive : {true, false}) {
    Model model = six_a_side();
    model.blue_on_positive_half = blue_positive;
    Engine engine(model);
    EXPECT_EQ(engine.tick(), 0);
    EXPECT_EQ(engine.truth().ball.position.head<2>(), Vector2d(0, 0));
    ASSERT_EQ(engine.truth().robots.size(), 12U);
    for (const truth::Robot& robot : engine.truth().robots) {
      EXPECT_EQ(robot.position.x() > 0, (robot.id.team == Team::Blue) == blue_positive);
    }
    EXPECT_TRUE(engine.detections().empty());
  }
}

TEST(Engine, MakesCamerasWhenThereAreNone) {
  EXPECT_EQ(Engine(six_a_side()).model().geometry.cameras.size(), 4U);
}

TEST(Engine, CountsTicksWithoutDrift) {
  Engine engine(six_a_side());
  for (int i = 0; i < 100; ++i) engine.step({});
  EXPECT_EQ(engine.tick(), 100);
  EXPECT_EQ(engine.time(), world::tick_time(100));
  EXPECT_EQ(engine.truth().tick, 100);
  EXPECT_EQ(engine.truth().time, world::tick_time(100));
}

TEST(Engine, OnlyTheRobotsOfTheModelArePresent) {
  Model model = six_a_side();
  model.robots[Team::Blue] = engine::standard_robots(Team::Blue, {9, 2});
  model.robots[Team::Yellow].clear();
  Engine engine(model);
  ASSERT_EQ(engine.truth().robots.size(), 2U);
  EXPECT_EQ(engine.truth().robots[0].id.number, 2);
  EXPECT_EQ(engine.truth().robots[1].id.number, 9);
  engine.step({});
}

TEST(Engine, CommandsWaitForTheirLatency) {
  for (const int latency : {0, 1, 2, 5}) {
    Model model = six_a_side();
    model.realism.radio.latency = latency;
    Engine engine(model);
    Commands commands;
    commands[Team::Yellow] = {forward(1, 1)};
    for (int step = 0; step < latency + 1; ++step) {
      EXPECT_EQ(find(engine, Team::Yellow, 1).velocity.norm(), 0) << latency << " " << step;
      engine.step(commands);
      commands[Team::Yellow].clear();  // given once, to the first step
    }
    // One tick of 3 m/s^2.
    EXPECT_NEAR(find(engine, Team::Yellow, 1).velocity.norm(), 0.05, 1e-6) << latency;
    engine.step({});
    engine.step({});
    EXPECT_NEAR(find(engine, Team::Yellow, 1).velocity.norm(), 0, 1e-6) << latency;  // missing: it stops
  }
}

TEST(Engine, VisionArrivesAfterItsDelay) {
  for (const int delay : {0, 1, 2}) {
    Model model = six_a_side();
    model.realism.vision.delay = delay;
    Engine engine(model);
    for (int step = 0; step < 6; ++step) {
      engine.step({});
      ASSERT_EQ(engine.detections().size(), step < delay ? 0U : 4U);
      if (engine.detections().empty()) continue;
      EXPECT_EQ(engine.detections()[3].t_capture,
                world::whole_microseconds(world::tick_time(engine.tick() - delay)));
    }
  }
}

TEST(Engine, DetectionsShowTheTruthOfTheirInstant) {
  Engine engine(six_a_side());
  Commands commands;
  commands[Team::Yellow] = {forward(2, 1)};
  for (int i = 0; i < 60; ++i) engine.step(commands);
  // Camera 3 (the last) takes its image at the end of the tick; the others see a robot less far.
  const Vector2d now = find(engine, Team::Yellow, 2).position;
  ASSERT_LT(std::abs(now.x()), 0.25);  // where two cameras see it
  int seen = 0;
  for (const world::Detection& frame : engine.detections()) {
    for (const world::DetectedRobot& robot : frame.robots) {
      if (robot.team != Team::Yellow || robot.number != 2) continue;
      ++seen;
      const double late = world::seconds(engine.time() - frame.t_capture);
      EXPECT_NEAR(robot.position.x(), now.x() - late, 1e-5) << frame.camera;  // whole microseconds and floats
    }
  }
  EXPECT_EQ(seen, 2);
}

TEST(Engine, BadCommandsCountAsNothing) {
  Engine engine(six_a_side());
  Commands commands;
  commands[Team::Yellow] = {forward(1, std::nan("")), forward(200, 1), forward(15, 1), forward(2, INFINITY)};
  world::RobotCommand wild = forward(3, 0);
  wild.kick_angle = std::nan("");
  commands[Team::Yellow].push_back(wild);
  for (int i = 0; i < 20; ++i) engine.step(commands);
  for (const truth::Robot& robot : engine.truth().robots) {
    EXPECT_EQ(robot.velocity.norm(), 0);
    EXPECT_TRUE(robot.position.allFinite());
  }
}

TEST(Engine, TheLastOfTwoCommandsForOneRobotCounts) {
  Engine engine(six_a_side());
  Commands commands;
  commands[Team::Yellow] = {forward(1, 1), forward(1, -1)};
  for (int i = 0; i < 5; ++i) engine.step(commands);
  EXPECT_LT(find(engine, Team::Yellow, 1).velocity.x(), 0);
}

TEST(Engine, SlowedTeamIsSlow) {
  Model model = six_a_side();
  model.robots[Team::Yellow] = engine::standard_robots(Team::Yellow, {0, 1, 2, 3, 4, 5}, 0.5);
  Engine engine(model);
  Commands commands;
  engine.put_robot({Team::Yellow, 2}, {-4, 2.6}, 0);
  engine.put_robot({Team::Blue, 3}, {4, -2.6}, M_PI);
  commands[Team::Yellow] = {forward(2, 3)};
  commands[Team::Blue] = {forward(3, 3)};
  for (int i = 0; i < 75; ++i) engine.step(commands);
  EXPECT_NEAR(find(engine, Team::Yellow, 2).velocity.norm(), 1.5, 1e-5);
  EXPECT_NEAR(find(engine, Team::Blue, 3).velocity.norm(), 3, 1e-5);
}

TEST(Engine, KicksAreInTheTruthOfTheirTickOnly) {
  Engine engine(six_a_side());
  engine.put_robot({Team::Blue, 4}, {0.2, -0.5}, M_PI);
  engine.place_ball({0.2 - 0.0945, -0.5});
  EXPECT_TRUE(find(engine, Team::Blue, 4).ball_contact);
  Commands commands;
  world::RobotCommand kick = forward(4, 0);
  kick.kick_speed = 5;
  commands[Team::Blue] = {kick};
  engine.step(commands);
  EXPECT_TRUE(engine.truth().kicks.empty());  // latency
  engine.step(commands);
  ASSERT_EQ(engine.truth().kicks.size(), 1U);
  EXPECT_EQ(engine.truth().kicks[0].robot, (world::RobotId{Team::Blue, 4}));
  EXPECT_LT(engine.truth().ball.velocity.x(), -4.9);
  engine.step(commands);
  EXPECT_TRUE(engine.truth().kicks.empty());
}

TEST(Engine, SpotIsFreeMeasuresFromTheHull) {
  Engine engine(six_a_side());
  engine.put_robot({Team::Blue, 4}, {1, -2.4}, 0);
  EXPECT_TRUE(engine.spot_is_free({1 - 0.25, -2.4}, 0.15));
  EXPECT_FALSE(engine.spot_is_free({1 - 0.23, -2.4}, 0.15));
  EXPECT_TRUE(engine.spot_is_free({1 + 0.23, -2.4}, 0.15));  // the front is flat
}

TEST(Engine, ResetOntoAnOccupiedSpot) {
  Engine engine(six_a_side());
  const Vector2d spot(1, 0.1);  // in a blue robot of the line-up
  EXPECT_FALSE(engine.spot_is_free(spot, 0.15));
  engine.push_robots_out(spot, 0.15);
  EXPECT_TRUE(engine.spot_is_free(spot, 0.15));
  engine.place_ball(spot);
  for (int i = 0; i < 60; ++i) engine.step({});
  EXPECT_LT((engine.truth().ball.position.head<2>() - spot).norm(), 1e-6);
}

TEST(Engine, RobotsLeaveAndComeBack) {
  Engine engine(six_a_side());
  engine.remove_robot({Team::Blue, 5});
  engine.remove_robot({Team::Blue, 5});
  engine.remove_robot({Team::Blue, 14});
  EXPECT_EQ(engine.truth().robots.size(), 11U);
  engine.step({});
  for (const world::Detection& frame : engine.detections()) {
    for (const world::DetectedRobot& robot : frame.robots) {
      EXPECT_FALSE(robot.team == Team::Blue && robot.number == 5);
    }
  }
  engine.put_robot({Team::Blue, 5}, {0, 3.2}, 1);
  EXPECT_EQ(find(engine, Team::Blue, 5).position.y(), static_cast<double>(3.2F));
  EXPECT_THROW(engine.put_robot({Team::Blue, 14}, {0, 0}, 0), std::invalid_argument);
}

// Random commands of everyone for `ticks` ticks, with teleports; a hash over truth and detections.
std::uint64_t hash_of_passage(Engine& engine, std::uint64_t seed, int ticks) {
  world::RandomStream random(seed, "passage");
  std::uint64_t hash = 0xcbf29ce484222325U;
  const auto add = [&](double value) {
    hash = (hash ^ std::bit_cast<std::uint64_t>(value)) * 0x100000001b3U;
  };
  Commands commands;
  for (int i = 0; i < ticks; ++i) {
    for (const Team team : world::both_teams) {
      commands[team].clear();
      for (int number = 0; number < 6; ++number) {
        const truth::Robot& robot = find(engine, team, number);
        const Vector2d to_ball = engine.truth().ball.position.head<2>() - robot.position;
        world::RobotCommand command = forward(number, 0);
        command.velocity_local =
            world::rotated(to_ball, -robot.orientation) + Vector2d(random.gaussian(), random.gaussian());
        command.angular_velocity = 3 * world::wrap_angle(world::angle_of(to_ball) - robot.orientation);
        command.kick_speed = random.uniform() < 0.2 ? 8 * random.uniform() : 0;
        command.kick_angle = random.uniform() < 0.3 ? 0.7 : 0;
        command.dribbler_speed = random.uniform() < 0.5 ? 100 : 0;
        commands[team].push_back(command);
      }
    }
    engine.step(commands);
    if (i % 150 == 149) {
      const Vector2d spot(4 * random.uniform() - 2, 4 * random.uniform() - 2);
      engine.push_robots_out(spot, 0.15);
      engine.place_ball(spot);
    }
    for (int k = 0; k < 3; ++k) add(engine.truth().ball.position[k]);
    for (const truth::Robot& robot : engine.truth().robots) {
      add(robot.position.x()), add(robot.position.y()), add(robot.orientation);
    }
    for (const truth::Contact& contact : engine.truth().contacts) add(contact.impulse);
    for (const world::Detection& frame : engine.detections()) {
      for (const world::DetectedBall& ball : frame.balls) add(ball.position.x()), add(ball.position.y());
      for (const world::DetectedRobot& robot : frame.robots) add(robot.position.x()), add(*robot.orientation);
    }
  }
  return hash;
}

std::uint64_t hash_of_passage(std::string_view realism, std::uint64_t seed, int ticks) {
  Engine engine(six_a_side(realism, seed));
  return hash_of_passage(engine, seed, ticks);
}

TEST(Engine, EveryContinuationOfASnapshotHasTheSameBits) {
  Engine engine(six_a_side("harsh", 3));
  hash_of_passage(engine, 3, 140);  // a crowd at the ball
  const engine::Snapshot snapshot = engine.snapshot();
  const engine::Snapshot copy = snapshot;
  const std::int64_t tick = engine.tick();

  Engine fresh(six_a_side("harsh", 3));
  fresh.restore(snapshot);
  EXPECT_EQ(fresh.tick(), tick);
  EXPECT_EQ(fresh.truth().ball.position, engine.truth().ball.position);
  const std::uint64_t first = hash_of_passage(fresh, 4, 300);

  hash_of_passage(engine, 5, 77);  // taking a snapshot is no promise to stay
  engine.restore(copy);
  EXPECT_EQ(hash_of_passage(engine, 4, 300), first);
  engine.restore(snapshot);
  EXPECT_NE(hash_of_passage(engine, 6, 300), first);
}

// Without touch there are no contact caches: noise, losses, delays, latencies, robots and
// ball go on as they were.
TEST(Engine, AContinuationIsTheOriginalWhileNothingTouches) {
  Engine engine(six_a_side("harsh", 3));
  hash_of_passage(engine, 3, 8);
  const engine::Snapshot snapshot = engine.snapshot();
  Engine other(six_a_side("harsh", 3));
  other.restore(snapshot);
  const std::uint64_t original = hash_of_passage(engine, 4, 15);
  ASSERT_TRUE(engine.truth().contacts.empty());
  EXPECT_EQ(hash_of_passage(other, 4, 15), original);
}

TEST(Engine, ASnapshotOfAnotherModelIsRefused) {
  Model model = six_a_side();
  model.robots[Team::Blue].pop_back();
  EXPECT_THROW(Engine(model).restore(Engine(six_a_side()).snapshot()), std::invalid_argument);
}

TEST(Engine, AnotherSeedGivesAnotherGame) {
  for (const char* realism : {"measured", "harsh"}) {
    EXPECT_NE(hash_of_passage(realism, 11, 600), hash_of_passage(realism, 12, 600));
  }
}

// Printed, to be compared between presets (dev, asan, release) by eye: rounding may differ with the
// optimiser, and then a crowd of bodies soon does (sim/README.md, Builds).
TEST(Engine, SameSeedAndCommandsGiveTheSameBits) {
  for (const char* realism : {"none", "measured", "harsh"}) {
    const std::uint64_t hash = hash_of_passage(realism, 11, 600);
    std::cout << "hash of 10 s, " << realism << ": " << std::hex << hash << std::dec << "\n";
    EXPECT_EQ(hash, hash_of_passage(realism, 11, 600));
  }
}

TEST(Engine, IsMovable) {
  Engine one(six_a_side());
  one.step({});
  Engine other = std::move(one);
  other.step({});
  EXPECT_EQ(other.tick(), 2);
}

}  // namespace

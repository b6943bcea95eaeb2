#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>

#include "autoref/calibrate/calibration.h"
#include "sim/engine/engine.h"

// Passages of the simulator with known parameters: robots driven at their limits, a ball kicked by a robot.

namespace calibrate {
namespace {

using engine::Engine;
using world::Team;
using world::Vector2d;

constexpr int ticks_of_a_kick = 240;

// Four robots of each team drive up and down beside the ball's lane, each in its own way: forward, sideways,
// turning; yellow 0 is put behind the ball again and again and kicks it.
Report played(const engine::Realism& realism, int kicks) {
  engine::Model model;
  for (const Team team : world::both_teams) {
    model.robots[team] = engine::standard_robots(team, {0, 1, 2, 3, 4}, 1, realism.robots);
  }
  model.realism = realism;
  model.seed = 7;
  Engine engine(model);
  engine.remove_robot({Team::Blue, 0});
  for (const Team team : world::both_teams) {
    const double side = team == Team::Yellow ? -1 : 1;
    for (std::uint8_t number = 1; number <= 4; ++number) {
      engine.put_robot({team, number}, {-3.5, side * (1.0 + 0.5 * number)}, number % 2 == 0 ? 1.5707963 : 0);
    }
  }
  Observer observer;
  for (int tick = 0; tick < kicks * ticks_of_a_kick; ++tick) {
    const int phase = tick % ticks_of_a_kick;
    const int kick = tick / ticks_of_a_kick;
    const double lane = -0.6 + 0.3 * (kick % 5);
    if (phase == 0) {
      engine.put_robot({Team::Yellow, 0}, {-4, lane}, 0);
      engine.place_ball({-4 + 0.073 + 0.0215, lane});
    }
    world::PerTeam<world::TeamCommands> commands;
    world::RobotCommand kicker;
    kicker.number = 0;
    if (phase >= 20) kicker.kick_speed = 1.5 + 0.5 * (kick % 10);  // up to 6 m/s
    commands[Team::Yellow].push_back(kicker);
    for (const Team team : world::both_teams) {
      for (std::uint8_t number = 1; number <= 4; ++number) {
        world::RobotCommand command;
        command.number = number;
        const double way = (tick / 120) % 2 == 0 ? 1 : -1;  // 2 s each
        if (number <= 2) {
          const Vector2d along(way * 9, 0);
          command.velocity_local = number == 2 ? Vector2d(0, -along.x()) : along;
        } else {
          command.angular_velocity = (tick / 60) % 2 == 0 ? 40 : -40;
        }
        commands[team].push_back(command);
      }
    }
    engine.step(commands);
    for (const world::Detection& image : engine.detections()) observer.add(image);
  }
  return calibrated(observer.finish(), engine.model().geometry);
}

void print(const Report& report, std::string_view key, double truth) {
  const Finding& found = *report.find(key);
  std::cout << "  " << key << ": truth " << truth << ", found " << found.value.value_or(-1) << " +- "
            << found.error << " (" << found.samples << ") " << found.missing << "\n";
}

void expect_found(const Report& report, std::string_view key, double truth, double tolerance = 0) {
  ASSERT_NE(report.find(key), nullptr) << key;
  const Finding& found = *report.find(key);
  ASSERT_TRUE(found.value) << key << ": " << found.missing;
  print(report, key, truth);
  EXPECT_NEAR(*found.value, truth, 3 * found.error + tolerance) << key;
}

void expect_all(const engine::Realism& realism) {
  const Report report = played(realism, 20);
  expect_found(report, "vision.ball_sigma", realism.vision.ball_sigma);
  expect_found(report, "vision.robot_sigma", realism.vision.robot_sigma);
  expect_found(report, "vision.orientation_sigma", realism.vision.orientation_sigma);
  expect_found(report, "vision.ball_missing", realism.vision.ball_missing);
  expect_found(report, "vision.robot_missing", realism.vision.robot_missing);
  expect_found(report, "vision.delay", realism.vision.delay);
  expect_found(report, "vision.camera_height", realism.vision.camera_height);
  expect_found(report, "vision.overlap", realism.vision.overlap, 0.02);  // seen at intervals of 3 m/s / 60 Hz
  expect_found(report, "ball.slide_deceleration", realism.physics.ball.slide_deceleration);
  expect_found(report, "ball.roll_deceleration", realism.physics.ball.roll_deceleration);
  expect_found(report, "robots.max_kick_speed", 6);
  for (const char* key :
       {"max_speed", "max_speed_sideways", "max_acceleration", "max_acceleration_sideways", "max_brake",
        "max_brake_sideways", "max_angular_speed", "max_angular_acceleration", "max_angular_brake"}) {
    const std::string name = std::string("robots.") + key;
    const auto truth =
        std::ranges::find(engine::realism_keys(), name, &engine::RealismKey::name)->get(realism);
    expect_found(report, name, truth);
    EXPECT_LT(report.find(name)->error, 0.2 * truth);  // it says something
  }
}

engine::Realism with_noise(double ball, double robot, double orientation) {
  engine::Realism realism = engine::realism("none");
  engine::set(realism, "vision.ball_sigma", ball);
  engine::set(realism, "vision.robot_sigma", robot);
  engine::set(realism, "vision.orientation_sigma", orientation);
  return realism;
}

TEST(Passages, WithTheNoiseOfMeasured) {
  engine::Realism realism = with_noise(0.0005, 0.00055, 0.0035);
  engine::set(realism, "vision.delay", 1);
  expect_all(realism);
}

TEST(Passages, WithTheNoiseAndLossOfHarsh) {
  engine::Realism realism = with_noise(0.0014, 0.0014, 0.01);
  engine::set(realism, "vision.ball_missing", 0.05);
  engine::set(realism, "vision.robot_missing", 0.02);
  engine::set(realism, "vision.delay", 2);
  expect_all(realism);
}

TEST(Passages, OnAnotherCarpetWithOtherRobotsAndCameras) {
  engine::Realism realism = with_noise(0.0008, 0.0004, 0.002);
  engine::set(realism, "vision.camera_height", 5.5);
  engine::set(realism, "vision.overlap", 0.5);
  engine::set(realism, "ball.slide_deceleration", 4.2);
  engine::set(realism, "ball.roll_deceleration", 0.45);
  engine::set(realism, "robots.max_speed", 2.2);
  engine::set(realism, "robots.max_speed_sideways", 2.2);
  engine::set(realism, "robots.max_acceleration", 4.0);
  engine::set(realism, "robots.max_acceleration_sideways", 4.0);
  engine::set(realism, "robots.max_brake", 5.0);
  engine::set(realism, "robots.max_brake_sideways", 5.0);
  engine::set(realism, "robots.max_angular_speed", 12);
  engine::set(realism, "robots.max_angular_acceleration", 35);
  engine::set(realism, "robots.max_angular_brake", 35);
  expect_all(realism);
}

}  // namespace
}  // namespace calibrate

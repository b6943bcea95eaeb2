#pragma once

#include <cmath>
#include <vector>

#include "sim/physics/world.h"
#include "sim/world/time.h"

/// A field with some robots, and what happened on it; robots are given as places, all with default specs.
struct Arena {
  struct At {
    world::Vector2d position;
    double orientation = 0;
  };

  explicit Arena(const std::vector<At>& places = {}, const world::RobotSpecs& like = {},
                 const physics::Params& params = {}, std::uint64_t seed = 0)
      : length(params.solver.substep_length),
        specs(numbered(places.size(), like)),
        world(field, specs, params, seed) {
    for (std::size_t i = 0; i < places.size(); ++i) {
      world.put_robot(i, places[i].position, places[i].orientation);
    }
    world.place_ball(world::Vector2d(0, 2));
  }

  static std::vector<world::RobotSpecs> numbered(std::size_t count, const world::RobotSpecs& like) {
    std::vector<world::RobotSpecs> all(count, like);
    for (std::size_t i = 0; i < count; ++i) {
      all[i].id = {i < 16 ? world::Team::Yellow : world::Team::Blue, static_cast<std::uint8_t>(i % 16)};
    }
    return all;
  }

  void step() {
    ++substeps;
    world.substep(world::Time{world::from_seconds(time())}, contacts, kicks);
  }
  /// Runs for a whole number of substeps nearest to `seconds`.
  void run(double seconds) {
    const long count = std::lround(seconds / length);
    for (long i = 0; i < count; ++i) step();
  }
  double time() const { return substeps * length; }

  truth::Robot robot(std::size_t index) {
    world.read_robots(robots);
    return robots.at(index);
  }
  const truth::Ball& ball() const { return world.ball(); }

  void place(const world::Vector3d& position, const world::Vector3d& velocity = world::Vector3d::Zero()) {
    truth::Ball ball;
    ball.position = position;
    ball.velocity = velocity;
    world.place_ball(ball);
  }
  void shoot(const world::Vector2d& from, const world::Vector2d& velocity) {
    truth::Ball ball;
    ball.position = {from.x(), from.y(), field.ball_radius};
    ball.velocity = {velocity.x(), velocity.y(), 0};
    world.place_ball(ball);
  }
  /// The same, already rolling.
  void roll(const world::Vector2d& from, const world::Vector2d& velocity) {
    truth::Ball ball;
    ball.position = {from.x(), from.y(), field.ball_radius};
    ball.velocity = {velocity.x(), velocity.y(), 0};
    ball.spin = {-velocity.y() / field.ball_radius, velocity.x() / field.ball_radius, 0};
    world.place_ball(ball);
  }

  double length;  // of a substep [s]
  world::Field field;
  std::vector<world::RobotSpecs> specs;
  physics::World world;
  std::vector<truth::Contact> contacts;
  std::vector<truth::Kick> kicks;
  std::vector<truth::Robot> robots;
  int substeps = 0;
};

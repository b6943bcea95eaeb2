#pragma once

#include "sim/world/random.h"
#include "tests/sim/physics/arena.h"

/// The reference scene's game played in the simulator: twelve robots, one chaser of each team that kicks 2 to
/// 8 m/s (15 % chips), the others driving to random targets; for determinism tests and for timing.
class Chase {
 public:
  explicit Chase(std::uint64_t seed, const physics::Params& params = {})
      : arena(line_up(), {}, params), random_(seed, "chase"), targets_(12), until_(12, 0) {
    arena.world.place_ball(world::Vector2d(0, 0));
  }

  void tick() {
    decide();
    arena.contacts.clear();
    arena.kicks.clear();
    arena.run(world::tick_length);
  }

  Arena arena;

 private:
  static std::vector<Arena::At> line_up() {
    std::vector<Arena::At> all;
    for (int i = 0; i < 12; ++i) {
      const double s = i < 6 ? -1 : 1;
      all.push_back({{s * (1 + i % 3), i % 6 < 3 ? 1.0 : -1.0}, i < 6 ? 0 : M_PI});
    }
    return all;
  }

  int chaser(int first) const {
    int best = first;
    const world::Vector2d ball = arena.ball().position.head<2>();
    for (int i = first; i < first + 6; ++i) {
      const auto distance = [&](int robot) {
        return (arena.robots[static_cast<std::size_t>(robot)].position - ball).norm();
      };
      if (distance(i) < distance(best)) best = i;
    }
    return best;
  }

  void decide() {
    arena.world.read_robots(arena.robots);
    const world::Vector2d ball = arena.ball().position.head<2>();
    const int chasers[2] = {chaser(0), chaser(6)};
    for (int i = 0; i < 12; ++i) {
      const auto index = static_cast<std::size_t>(i);
      const truth::Robot& robot = arena.robots[index];
      const bool chases = i == chasers[0] || i == chasers[1];
      if (chases) {
        targets_[index] = ball;
      } else if (--until_[index] < 0) {
        targets_[index] = {8.8 * random_.uniform() - 4.4, 5.8 * random_.uniform() - 2.9};
        until_[index] = 60 + static_cast<int>(random_.below(120));
      }
      const world::Vector2d way = targets_[index] - robot.position;
      world::RobotCommand command;
      const double speed = std::min(4 * way.norm(), 3.0);
      if (way.norm() > 0) {
        command.velocity_local = world::rotated(way.normalized() * speed, -robot.orientation);
      }
      const double aim = world::angle_of(ball - robot.position);
      command.angular_velocity = std::clamp(8 * world::wrap_angle(aim - robot.orientation), -10.0, 10.0);
      if (chases) {
        command.kick_speed = 2 + 6 * random_.uniform();
        command.kick_angle = random_.uniform() < 0.15 ? M_PI / 4 : 0;
      }
      arena.world.set_command(index, command);
    }
    const bool stuck = arena.ball().velocity.norm() < 0.05 || std::abs(ball.x()) > 4.52;
    still_ = stuck ? still_ + 1 : 0;
    if (still_ >= 180) {
      still_ = 0;
      arena.world.place_ball(world::Vector2d(6 * random_.uniform() - 3, 4 * random_.uniform() - 2));
    }
  }

  world::RandomStream random_;
  std::vector<world::Vector2d> targets_;
  std::vector<int> until_;
  int still_ = 0;
};

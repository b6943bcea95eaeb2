// Fast balls against everything that has to stop them, over angles and sub-frame phases.

#include <gtest/gtest.h>

#include "sim/physics/hull.h"
#include "tests/sim/physics/arena.h"

namespace {

using world::Vector2d;

// How a sweep went: the deepest overlap seen at the end of a substep [m], and shots that came out on the
// other side.
struct Sweep {
  double worst = 0;
  int through = 0;
  int shots = 0;
};

constexpr int phases = 16;

// A phase shifts the start by a part of what the ball covers in one substep.
Vector2d start(const Vector2d& target, const Vector2d& direction, double distance, double speed, int phase) {
  return target - direction * (distance + speed * world::substep_length * phase / phases);
}

// @param towards  speed of the robot towards the shot [m/s]
Sweep shots_at_robot(double speed, double towards) {
  Sweep sweep;
  for (int side = 0; side < 24; ++side) {        // where on the hull
    for (int slant = -2; slant <= 2; ++slant) {  // how far off its centre: up to 50 mm
      for (int phase = 0; phase < phases; ++phase) {
        const Vector2d direction = world::direction(side * 2 * M_PI / 24);
        const Vector2d across{-direction.y(), direction.x()};
        Arena arena({{direction * towards * 0.025, 0}});  // they meet near the origin
        arena.world.set_motion(0, -direction * towards, 0);
        world::RobotCommand on;
        on.velocity_local = -direction * towards;
        arena.world.set_command(0, on);
        arena.shoot(start(across * 0.025 * slant, direction, 0.3, speed, phase), direction * speed);
        bool passed = false;
        for (int i = 0; i < 36; ++i) {
          arena.step();
          const Vector2d ball = arena.ball().position.head<2>();
          const truth::Robot robot = arena.robot(0);
          const double gap =
              physics::hull_distance(arena.specs[0], robot.position, robot.orientation, ball) - 0.0215;
          sweep.worst = std::max(sweep.worst, -gap);
          // Behind the robot within its width: only through it. (A glance off its side ends up farther out.)
          const Vector2d from_robot = ball - robot.position;
          if (from_robot.dot(direction) > 0.08 && std::abs(from_robot.dot(across)) < 0.06) passed = true;
        }
        if (passed) ++sweep.through;
        ++sweep.shots;
      }
    }
  }
  return sweep;
}

Sweep shots_at_wall(double speed) {
  Sweep sweep;
  const double x = 5.2 - 0.0215, y = 3.7 - 0.0215;
  for (int angle = 0; angle < 48; ++angle) {
    for (int phase = 0; phase < phases; ++phase) {
      Arena arena;
      const Vector2d direction = world::direction(angle * 2 * M_PI / 48);
      arena.shoot(start({4.9 * std::copysign(1.0, direction.x()), 3.4 * std::copysign(1.0, direction.y())},
                        direction, 0.1, speed, phase),
                  direction * speed);
      for (int i = 0; i < 60; ++i) {
        arena.step();
        const Vector2d ball = arena.ball().position.head<2>();
        sweep.worst = std::max({sweep.worst, std::abs(ball.x()) - x, std::abs(ball.y()) - y});
      }
      const Vector2d ball = arena.ball().position.head<2>();
      if (std::abs(ball.x()) > 5.2 || std::abs(ball.y()) > 3.7) ++sweep.through;
      ++sweep.shots;
    }
  }
  return sweep;
}

// From inside the goal at its back and sides, from in front of it at the posts, from outside at its sides and
// back.
Sweep shots_at_goal(double speed) {
  Sweep sweep;
  for (int place = 0; place < 9; ++place) {
    for (int angle = 0; angle < 24; ++angle) {
      for (int phase = 0; phase < phases; ++phase) {
        Arena arena;
        const bool inside = place < 5;
        const Vector2d from = inside ? Vector2d(4.55, -0.4 + 0.2 * place)
                                     : Vector2d(4.56 + 0.05 * (place - 5), place % 2 == 0 ? 0.70 : -0.70);
        const Vector2d direction = world::direction(angle * 2 * M_PI / 24);
        arena.shoot(from + direction * (speed * world::substep_length * phase / phases * 0.5),
                    direction * speed);
        bool left_through_mouth = false;
        Vector2d before = arena.ball().position.head<2>();
        for (int i = 0; i < 24; ++i) {
          arena.step();
          const Vector2d ball = arena.ball().position.head<2>();
          if ((before.x() - 4.5) * (ball.x() - 4.5) <= 0) {
            const double share = (4.5 - before.x()) / (ball.x() - before.x());
            if (std::abs(before.y() + share * (ball.y() - before.y())) < 0.5) left_through_mouth = true;
          }
          before = ball;
          if (inside && !left_through_mouth && ball.x() > 4.5) {
            sweep.worst =
                std::max({sweep.worst, ball.x() - (4.68 - 0.0215), std::abs(ball.y()) - (0.5 - 0.0215)});
          }
        }
        const Vector2d ball = arena.ball().position.head<2>();
        const bool ends_inside = ball.x() > 4.5 && ball.x() < 4.68 && std::abs(ball.y()) < 0.5;
        if (inside && !left_through_mouth && !ends_inside) ++sweep.through;
        if (!inside && ends_inside && !left_through_mouth) ++sweep.through;
        ++sweep.shots;
      }
    }
  }
  return sweep;
}

// Bullet sees an overlap only after it has happened, so it can be as deep as one step's travel, 33 mm at 8
// m/s; corners of the hull lie off the nominal circle by 0.7 mm, and a slanting ball slides on for a step
// while it is pushed out. Walls, 0.2 m thick, are left to single steps at any speed.
double deepest(const std::string& what, double speed) {
  return (what == "wall" ? speed : 8) * world::substep_length + 0.003;
}

void expect_stopped(const char* what, const Sweep& sweep, double speed) {
  std::printf("%s at %.0f m/s: %d shots, worst overlap %.1f mm\n", what, speed, sweep.shots,
              sweep.worst * 1000);
  EXPECT_EQ(sweep.through, 0) << what << " at " << speed;
  EXPECT_LT(sweep.worst, deepest(what, speed)) << what << " at " << speed;
}

TEST(Tunnelling, NoBallPassesThroughARobot) {
  for (const double speed : {4.9, 8.0, 10.0}) {
    expect_stopped("resting robot", shots_at_robot(speed, 0), speed);
    expect_stopped("coming robot", shots_at_robot(speed, 3), speed);
  }
}
TEST(Tunnelling, NoBallPassesThroughAWall) {
  for (const double speed : {8.0, 10.0}) expect_stopped("wall", shots_at_wall(speed), speed);
}
TEST(Tunnelling, NoBallPassesThroughAGoal) {
  for (const double speed : {8.0, 10.0}) expect_stopped("goal", shots_at_goal(speed), speed);
}

TEST(Tunnelling, NoRobotPassesThroughAnotherOrAWall) {
  // Full speed head-on, 6 m/s closing, at eight headings and sixteen phases.
  double worst = 0;
  for (int side = 0; side < 8; ++side) {
    for (int phase = 0; phase < phases; ++phase) {
      const double shift = 3 * world::substep_length * phase / phases;
      Arena arena({{{-0.3 - shift, 0}, side * M_PI / 4}, {{0.3, 0.02}, M_PI}});
      arena.world.set_motion(0, {3, 0}, 0);
      arena.world.set_motion(1, {-3, 0}, 0);
      world::RobotCommand command;
      command.velocity_local = world::rotated({3, 0}, -side * M_PI / 4);
      arena.world.set_command(0, command);
      command.velocity_local = {3, 0};
      arena.world.set_command(1, command);
      for (int i = 0; i < 48; ++i) {
        arena.step();
        const Vector2d between = arena.robot(1).position - arena.robot(0).position;
        ASSERT_GT(between.x(), 0.1);
        worst = std::max(worst, 0.146 - between.norm());  // less than front to front is certainly overlap
      }
    }
  }
  EXPECT_LT(worst, 6 * world::substep_length);

  Arena arena({{{4.9, 0.9}, 0}});
  arena.world.set_motion(0, {3, 0}, 0);
  world::RobotCommand on;
  on.velocity_local = {3, 0};
  arena.world.set_command(0, on);
  for (int i = 0; i < 240; ++i) {
    arena.step();
    ASSERT_LT(arena.robot(0).position.x() + 0.073, 5.2 + 3 * world::substep_length);
  }
}

}  // namespace

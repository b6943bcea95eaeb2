#pragma once

#include <algorithm>

#include "sim/physics/fixtures.h"
#include "sim/physics/hull.h"
#include "tests/sim/physics/arena.h"

/// How a sweep went: the deepest overlap seen at the end of a substep [m], and shots that came
/// out on the other side.
struct Sweep {
  double worst = 0;
  int through = 0;
  int shots = 0;
};

constexpr int sweep_phases = 16;

/// A phase shifts the start by a part of what the ball covers in one substep.
inline world::Vector2d start(const world::Vector2d& target, const world::Vector2d& direction, double distance,
                             double speed, int phase, double length) {
  return target - direction * (distance + speed * length * phase / sweep_phases);
}

/// @param towards  speed of the robot towards the shot [m/s]
inline Sweep shots_at_robot(double speed, double towards, const physics::Params& params = {}) {
  using world::Vector2d;
  const double length = params.solver.substep_length;
  Sweep sweep;
  for (int side = 0; side < 24; ++side) {        // where on the hull
    for (int slant = -2; slant <= 2; ++slant) {  // how far off its centre: up to 50 mm
      for (int phase = 0; phase < sweep_phases; ++phase) {
        const Vector2d direction = world::direction(side * 2 * M_PI / 24);
        const Vector2d across{-direction.y(), direction.x()};
        Arena arena({{direction * towards * 0.025, 0}}, {}, params);  // they meet near the origin
        arena.world.set_motion(0, -direction * towards, 0);
        world::RobotCommand on;
        on.velocity_local = -direction * towards;
        arena.world.set_command(0, on);
        arena.shoot(start(across * 0.025 * slant, direction, 0.3, speed, phase, length), direction * speed);
        bool passed = false;
        for (int i = 0; i < 0.15 / length; ++i) {
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

inline Sweep shots_at_wall(double speed, const physics::Params& params = {}) {
  using world::Vector2d;
  const double length = params.solver.substep_length;
  Sweep sweep;
  const double x = 5.2 - 0.0215, y = 3.7 - 0.0215;
  for (int angle = 0; angle < 48; ++angle) {
    for (int phase = 0; phase < sweep_phases; ++phase) {
      Arena arena({}, {}, params);
      const Vector2d direction = world::direction(angle * 2 * M_PI / 48);
      arena.shoot(start({4.9 * std::copysign(1.0, direction.x()), 3.4 * std::copysign(1.0, direction.y())},
                        direction, 0.1, speed, phase, length),
                  direction * speed);
      for (int i = 0; i < 0.25 / length; ++i) {
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

/// From inside the goal at its back and sides, from in front of it at the posts, from outside
/// at its sides and back.
inline Sweep shots_at_goal(double speed, const physics::Params& params = {}) {
  using world::Vector2d;
  const double length = params.solver.substep_length;
  Sweep sweep;
  for (int place = 0; place < 9; ++place) {
    for (int angle = 0; angle < 24; ++angle) {
      for (int phase = 0; phase < sweep_phases; ++phase) {
        Arena arena({}, {}, params);
        const bool inside = place < 5;
        const Vector2d from = inside ? Vector2d(4.55, -0.4 + 0.2 * place)
                                     : Vector2d(4.56 + 0.05 * (place - 5), place % 2 == 0 ? 0.70 : -0.70);
        const Vector2d direction = world::direction(angle * 2 * M_PI / 24);
        arena.shoot(from + direction * (speed * length * phase / sweep_phases * 0.5), direction * speed);
        bool left_through_mouth = false;
        Vector2d before = arena.ball().position.head<2>();
        for (int i = 0; i < 0.1 / length; ++i) {
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

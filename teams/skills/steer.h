#pragma once

#include <array>

#include "sim/world/robot_command.h"
#include "teams/skills/order.h"
#include "teams/skills/path.h"

namespace skills {

/// Turns orders into commands: path round obstacles, time-optimal velocity along it, brakes before others.
///
/// Remembers, per robot, on which side it passes its present obstacle; nothing else that matters.
class Steering {
 public:
  world::RobotCommand command(const kit::View& view, const kit::Robot& robot, const Order& order);

 private:
  std::array<int, world::max_robot_number + 1> side_{};
  std::array<int, world::max_robot_number + 1> cells_{};  // of Drive: where to look first, no more
};

/// Takes from a velocity what would run into another robot: towards it at most as fast
/// as can still be braked.
///
/// @param margin  air to keep [m]
Vector2d without_collisions(const kit::View& view, const kit::Robot& robot, Vector2d velocity, double margin);

/// Takes from a velocity what would enter a defense area, and drives out of it.
Vector2d outside_area(const kit::View& view, const kit::Robot& robot, world::Side side, Vector2d velocity,
                      double margin);

/// The order's target moved to where the robot may stand: on the field, outside the areas forbidden to it.
Vector2d legal_target(const kit::View& view, const kit::Robot& robot, const Order& order);

/// The angular velocity of the next tick towards a heading [rad/s].
double turning(const kit::Robot& robot, double heading, double max_turn);

}  // namespace skills

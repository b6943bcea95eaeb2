#pragma once

#include <vector>

#include "sim/vision/cameras.h"

// What the tests of the cameras share.
namespace scene {

inline world::Geometry geometry(int cameras = 4) {
  world::Geometry geometry;
  geometry.cameras = world::camera_grid(geometry.field, cameras, 4);
  return geometry;
}

inline truth::Ball ball_at(double x, double y, double height = 0) {
  truth::Ball ball;
  ball.position = {x, y, 0.0215 + height};
  return ball;
}

inline truth::Robot robot_at(double x, double y, double orientation, int number = 3,
                             world::Team team = world::Team::Blue) {
  truth::Robot robot;
  robot.id = {team, static_cast<std::uint8_t>(number)};
  robot.position = {x, y};
  robot.orientation = orientation;
  return robot;
}

// One tick with everything standing still; what is delivered at its end.
inline std::vector<world::Detection> tick(vision::Cameras& cameras, std::int64_t number,
                                          const truth::Ball& ball,
                                          const std::vector<truth::Robot>& robots = {}) {
  cameras.begin_tick();
  for (int substep = 1; substep <= 4; ++substep) {
    cameras.capture(substep, world::tick_time(number, substep), ball, robots);
  }
  const auto delivered = cameras.delivered();
  return {delivered.begin(), delivered.end()};
}

}  // namespace scene

#pragma once

#include <vector>

#include "sim/engine/engine.h"
#include "sim/truth/truth.h"
#include "sim/world/detection.h"

namespace fuzz {

/// Two thirds of a second of two against two: the ball rolls over the touch line off a
/// robot that drives after it.
struct Passage {
  struct Tick {
    truth::Frame truth;
    std::vector<world::Detection> images;
  };
  engine::Model model;
  std::vector<Tick> ticks;
};

inline Passage passage(int length) {
  Passage passage;
  for (const world::Team team : world::both_teams) {
    passage.model.robots[team] = engine::standard_robots(team, {0, 1});
  }
  passage.model.realism = engine::realism("measured");
  passage.model.geometry.cameras = world::camera_grid(passage.model.geometry.field, 2, 4.0);
  passage.model.seed = 3;
  engine::Engine engine(passage.model);
  const double line = passage.model.geometry.field.half_width();
  engine.put_robot({world::Team::Yellow, 1}, {1, line - 0.5}, 1.5708);
  engine.put_robot({world::Team::Blue, 1}, {1.3, line - 0.2}, 3.0);
  truth::Ball ball = engine.truth().ball;
  ball.position.head<2>() = world::Vector2d(1, line - 0.385);
  engine.put_ball(ball);
  world::RobotCommand kick;
  kick.number = 1;
  kick.velocity_local = {1, 0};
  kick.kick_speed = 3;
  kick.dribbler_speed = 50;
  for (int tick = 0; tick < length; ++tick) {
    engine.step({.yellow = {kick}, .blue = {}});
    const auto images = engine.detections();
    passage.ticks.push_back({engine.truth(), {images.begin(), images.end()}});
  }
  passage.model = engine.model();
  return passage;
}

}  // namespace fuzz

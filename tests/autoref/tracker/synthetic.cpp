#include "tests/autoref/tracker/synthetic.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace synthetic {
namespace {

constexpr double overlap = 0.3;  // [m] a camera sees beyond its quarter

bool sees(int camera, const Vector2d& p) {
  const double sx = camera % 2 == 0 ? -1 : 1;
  const double sy = camera / 2 == 0 ? -1 : 1;
  return sx * p.x() > -overlap && sy * p.y() > -overlap;
}

}  // namespace

std::vector<world::Detection> Cameras::images(std::int64_t tick, const Motion& motion) {
  std::vector<world::Detection> images;
  const auto noisy = [this](const Vector2d& p, double sigma) -> Vector2d {
    const double x = stream_.gaussian();
    const double y = stream_.gaussian();
    return world::as_on_wire(Vector2d(p + sigma * Vector2d(x, y)));
  };
  for (int camera = 0; camera < world::substeps_per_tick; ++camera) {
    world::Detection image;
    image.camera = camera;
    image.frame_number = static_cast<std::uint32_t>(tick);
    image.t_capture = world::whole_microseconds(world::tick_time(tick - 1, camera + 1));
    image.t_sent = image.t_capture;
    const Scene scene = motion(world::seconds(image.t_capture));
    if (scene.ball && sees(camera, *scene.ball)) {
      image.balls.push_back({.position = noisy(*scene.ball, noise_.ball)});
    }
    for (const Scene::Robot& robot : scene.robots) {
      if (!sees(camera, robot.position)) continue;
      image.robots.push_back(
          {.team = robot.id.team,
           .number = robot.id.number,
           .position = noisy(robot.position, noise_.robot),
           .orientation = world::wrap_angle(robot.heading + noise_.heading * stream_.gaussian())});
    }
    images.push_back(image);
  }
  return images;
}

Vector2d GroundBall::velocity(double seconds) const {
  const double v0 = kick.norm();
  if (v0 == 0) return Vector2d::Zero();
  const double slide_time = slides ? v0 * (2.0 / 7.0) / 3.0 : 0;
  const double v = seconds < slide_time
                       ? v0 - 3.0 * seconds
                       : std::max(0.0, v0 - 3.0 * slide_time - 0.26 * (seconds - slide_time));
  return kick / v0 * v;
}

Vector2d GroundBall::position(double seconds) const {
  const double v0 = kick.norm();
  if (v0 == 0) return start;
  const double slide_time = slides ? v0 * (2.0 / 7.0) / 3.0 : 0;
  const double t1 = std::min(seconds, slide_time);
  const double v1 = v0 - 3.0 * slide_time;
  const double t2 = std::clamp(seconds - slide_time, 0.0, v1 / 0.26);
  return start + kick / v0 * (v0 * t1 - 1.5 * t1 * t1 + v1 * t2 - 0.13 * t2 * t2);
}

GameRobot::GameRobot(std::uint64_t seed, double duration) {
  world::RandomStream stream(seed, "game robot");
  constexpr double dt = 0.001;
  Sample now{{4 * stream.uniform() - 2, 4 * stream.uniform() - 2}, Vector2d::Zero(), 0};
  Vector2d wanted = Vector2d::Zero();
  double wanted_turn = 0;
  double turn = 0;
  double until = 0;
  for (double t = 0; t < duration + 0.1; t += dt) {
    if (t >= until) {
      until = t + 0.3 + 1.2 * stream.uniform();
      wanted = 2.5 * stream.uniform() * world::direction(2 * std::numbers::pi * stream.uniform());
      if (now.position.norm() > 2.5) wanted = -now.position / 2;
      wanted_turn = 16 * stream.uniform() - 8;
    }
    const Vector2d missing = wanted - now.velocity;
    const double limit = (missing.dot(now.velocity) < 0 ? 6.0 : 3.0) * dt;
    const Vector2d before = now.velocity;
    now.velocity += missing.norm() <= limit ? missing : Vector2d(missing.normalized() * limit);
    now.position += (before + now.velocity) / 2 * dt;
    turn += std::clamp(wanted_turn - turn, -50.0 * dt, 50.0 * dt);
    now.heading = world::wrap_angle(now.heading + turn * dt);
    samples_.push_back(now);
  }
}

const GameRobot::Sample& GameRobot::at(double seconds) const {
  const auto index = static_cast<std::size_t>(std::max(0.0, seconds * 1000));
  return samples_[std::min(index, samples_.size() - 1)];
}
Vector2d GameRobot::position(double seconds) const {
  const Sample& sample = at(seconds);
  return sample.position + sample.velocity * (seconds - std::floor(seconds * 1000) / 1000);
}
Vector2d GameRobot::velocity(double seconds) const { return at(seconds).velocity; }
double GameRobot::heading(double seconds) const { return at(seconds).heading; }

}  // namespace synthetic

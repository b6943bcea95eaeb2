#include "sim/vision/cameras.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>

namespace vision {
namespace {

using world::Vector2d;
using world::Vector3d;

// A camera has to hang above everything it looks at [m]; robots are 0.15 m high.
constexpr double lowest_camera = 0.5;

void check(const world::Geometry& geometry, const Params& params) {
  const auto require = [](bool holds, const std::string& sentence) {
    if (!holds) throw std::invalid_argument("vision: " + sentence);
  };
  require(!geometry.cameras.empty(), "there must be at least one camera");
  std::set<int> ids;
  for (const world::Camera& camera : geometry.cameras) {
    const std::string name = "camera " + std::to_string(camera.id);
    require(camera.position.allFinite() && camera.position.z() >= lowest_camera,
            name + " must be at least 0.5 m high, is at " + std::to_string(camera.position.z()) + " m");
    require(ids.insert(camera.id).second, name + " is there twice");
  }
  const auto not_negative = [&](const char* name, double value) {
    require(std::isfinite(value) && value >= 0,
            std::string(name) + " must be 0 or more, is " + std::to_string(value));
  };
  not_negative("ball_sigma", params.ball_sigma);
  not_negative("robot_sigma", params.robot_sigma);
  not_negative("orientation_sigma", params.orientation_sigma);
  not_negative("ball_missing", params.ball_missing);
  not_negative("robot_missing", params.robot_missing);
  not_negative("overlap", params.overlap);
  not_negative("delay", params.delay);
  require(params.ball_missing <= 1 && params.robot_missing <= 1, "a probability must be at most 1");
  require(params.delay <= 60, "delay must be at most 60 ticks, is " + std::to_string(params.delay));
}

// Beyond this difference two cameras stand in different columns or rows [m].
constexpr double different = 0.1;

// The middle between a camera and its nearest neighbour on the side `sign` of one axis, plus the overlap.
double limit(std::span<const world::Camera> cameras, const world::Camera& self, int axis, double sign,
             double overlap) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const world::Camera& other : cameras) {
    const double ahead = sign * (other.position[axis] - self.position[axis]);
    if (ahead > different) nearest = std::min(nearest, ahead);
  }
  return self.position[axis] + sign * (nearest / 2 + overlap);
}

}  // namespace

bool Cameras::Area::contains(const Vector2d& point) const {
  return point.x() >= min_x && point.x() <= max_x && point.y() >= min_y && point.y() <= max_y;
}

Cameras::Cameras(const world::Geometry& geometry, const Params& params, std::uint64_t seed)
    : params_(params), ball_radius_(geometry.field.ball_radius) {
  check(geometry, params);
  batches_.resize(static_cast<std::size_t>(params.delay) + 1);
  for (std::size_t i = 0; i < geometry.cameras.size(); ++i) {
    const world::Camera& camera = geometry.cameras[i];
    const auto edge = [&](int axis, double sign) {
      return limit(geometry.cameras, camera, axis, sign, params.overlap);
    };
    const std::string name = "vision camera " + std::to_string(i);
    cameras_.push_back({camera,
                        {edge(0, -1), edge(0, 1), edge(1, -1), edge(1, 1)},
                        static_cast<int>(i) % world::substeps_per_tick + 1,
                        0,
                        {seed, name + " noise"},
                        {seed, name + " loss"}});
  }
  for (Batch& batch : batches_) batch.detections.resize(cameras_.size());
}

void Cameras::begin_tick() {
  present_ = (present_ + 1) % batches_.size();
  batches_[present_].count = 0;
}

bool Cameras::captures_after(int substep) const {
  return std::any_of(cameras_.begin(), cameras_.end(),
                     [&](const CameraState& camera) { return camera.substep == substep; });
}

void Cameras::capture(int substep, world::Time now, const truth::Ball& ball,
                      std::span<const truth::Robot> robots) {
  Batch& batch = batches_[present_];
  for (CameraState& camera : cameras_) {
    if (camera.substep == substep) take_image(camera, now, ball, robots, batch.detections[batch.count++]);
  }
}

std::span<const world::Detection> Cameras::delivered() const {
  const Batch& oldest = batches_[(present_ + 1) % batches_.size()];
  return {oldest.detections.data(), oldest.count};
}

// Every object in view draws its noise and its loss whether it is then reported or not: so a change of one
// probability leaves all other draws as they were.
void Cameras::take_image(CameraState& camera, world::Time now, const truth::Ball& ball,
                         std::span<const truth::Robot> robots, world::Detection& out) {
  out.camera = camera.camera.id;
  out.frame_number = camera.frame_number++;
  out.t_capture = world::whole_microseconds(now);
  out.t_sent = world::whole_microseconds(now + world::from_seconds(params_.delay * world::tick_length));
  out.balls.clear();
  out.robots.clear();

  const auto noise = [&](double sigma) { return sigma * camera.noise.gaussian(); };

  // The resting ball's height is the radius by which the league's calibration counts heights from zero.
  const Vector2d ball_seen = projected_to_ground(camera.camera.position, ball.position, ball_radius_);
  if (camera.area.contains(ball_seen)) {
    const double dx = noise(params_.ball_sigma);
    const double dy = noise(params_.ball_sigma);
    if (camera.loss.uniform() >= params_.ball_missing) {
      world::DetectedBall& seen = out.balls.emplace_back();
      seen.position = world::as_on_wire(Vector2d(ball_seen + Vector2d(dx, dy)));
    }
  }
  for (const truth::Robot& robot : robots) {
    if (!camera.area.contains(robot.position)) continue;
    const double dx = noise(params_.robot_sigma);
    const double dy = noise(params_.robot_sigma);
    const double turned = noise(params_.orientation_sigma);
    if (camera.loss.uniform() < params_.robot_missing) continue;
    world::DetectedRobot& seen = out.robots.emplace_back();
    seen.team = robot.id.team;
    seen.number = robot.id.number;
    seen.position = world::as_on_wire(Vector2d(robot.position + Vector2d(dx, dy)));
    seen.orientation = world::as_float(world::wrap_angle(robot.orientation + turned));
  }
}

Vector2d projected_to_ground(const Vector3d& camera, const Vector3d& ball, double ball_radius) {
  const double height = std::clamp(ball.z() - ball_radius, 0.0, 0.9 * camera.z());
  if (height == 0) return ball.head<2>();  // to the bit
  const Vector2d foot = camera.head<2>();
  return foot + (ball.head<2>() - foot) * (camera.z() / (camera.z() - height));
}

}  // namespace vision

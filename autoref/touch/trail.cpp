#include "autoref/touch/trail.h"

#include <cmath>

namespace touch {
namespace {

using namespace std::chrono_literals;

constexpr double near_robot = 0.40;    // [m] centre to centre, as in views
constexpr double same_ball = 0.15;     // [m] of the tracked one, as in views
constexpr double fastest = 12;         // [m/s] faster is a teleport, as in views
constexpr double slack = 0.2;          // [m]
constexpr double rate = 0.05;          // of learning a camera's offset: a third of a second
constexpr double hidden_share = 0.1;   // of the shift of a ball that is partly hidden, its error
constexpr double flight_sigma = 0.01;  // [m] of a ball that is followed in space
constexpr double gravity = 9.81;       // [m/s^2]
constexpr world::Duration least_step = 6ms;
constexpr double over_hull = 0.035;  // [m] seen so deep in a hull, it is in the air; contacts: up to 25 mm
constexpr double same_robot = 0.1;   // [m]
constexpr world::Duration longest_gap = 1500ms;  // between sightings; longer is another story

}  // namespace

Trail::Camera& Trail::camera(int id) {
  for (Camera& camera : cameras_) {
    if (camera.id == id) return camera;
  }
  return cameras_.emplace_back(Camera{.id = id});
}

void Trail::learn(Camera& camera, const world::Detection& image, const world::TrackedFrame& frame) {
  Vector2d sum = Vector2d::Zero();
  int count = 0;
  const double ago = world::seconds(image.t_capture - frame.time);
  for (const world::DetectedRobot& seen : image.robots) {
    if (!seen.number || *seen.number > world::max_robot_number) continue;
    const world::TrackedRobot* robot = world::find_robot(frame, {seen.team, *seen.number});
    if (robot == nullptr) continue;
    const Vector2d off = seen.position - (robot->position + robot->velocity * ago);
    if (!(off.norm() < same_robot)) continue;
    sum += off;
    ++count;
  }
  if (count == 0) return;
  const Vector2d mean = sum / count;
  camera.offset += (camera.known ? rate : 1) * (mean - camera.offset);
  camera.known = true;
}

optics::WholeBall Trail::whole(const Vector2d& seen, const world::Detection& image) const {
  const auto camera = std::ranges::find(geometry_.cameras, image.camera, &world::Camera::id);
  if (camera == geometry_.cameras.end()) return {seen};
  optics::PartlyHidden ball(geometry_.field, *camera, seen);
  for (const world::DetectedRobot& robot : image.robots) {
    if (robot.orientation) ball.beside(robot.position, *robot.orientation);
  }
  return ball.whole();
}

world::Vector3d Trail::camera_near(const Vector2d& place) const {
  const auto way2 = [&](const world::Camera& camera) {
    return (camera.position.head<2>() - place).squaredNorm();
  };
  const auto nearest = std::ranges::min_element(geometry_.cameras, {}, way2);
  return nearest == geometry_.cameras.end() ? world::Vector3d(place.x(), place.y(), 4) : nearest->position;
}

TrailPoint& Trail::push() {
  newest_ = (newest_ + 1) % memory;
  ++count_;
  TrailPoint& point = ring_[static_cast<std::size_t>(newest_)];
  point = TrailPoint{};
  return point;
}

void Trail::lift(const world::Flight& flight) {
  for (int n = count() - 1; n >= 0; --n) {
    TrailPoint& point = ring_[static_cast<std::size_t>((newest_ - count() + 1 + n + memory) % memory)];
    if (point.time <= flight.kicked) return;
    const double t = world::seconds(point.time - flight.kicked);
    const double height = flight.launch_velocity.z() * t - gravity / 2 * t * t;
    if (!point.seen || point.height > 0 || height <= 0) continue;
    const world::Vector3d camera = camera_near(point.ball);
    const Vector2d foot = camera.head<2>();
    point.ball = foot + (point.ball - foot) * ((camera.z() - height) / camera.z());
    point.height = height;
    point.sigma = flight_sigma;
    point.airborne = 1;
  }
}

void Trail::add(const world::TrackedFrame& frame, std::span<const world::Detection> images, std::size_t told,
                double probability) {
  if (!frame.ball) {
    reset();
    return;
  }
  const Vector2d here = frame.ball->position.head<2>();
  const Vector2d velocity = frame.ball->velocity.head<2>();
  const world::Detection* chosen = nullptr;
  Vector2d ball = here;
  double sigma = 0;
  for (const world::Detection& image : images) {
    Camera& its = camera(image.camera);
    learn(its, image, frame);
    const Vector2d expected = here + velocity * world::seconds(image.t_capture - frame.time);
    std::optional<optics::WholeBall> found;
    double least = same_ball;
    for (const world::DetectedBall& seen : image.balls) {
      const double distance = (seen.position - its.offset - expected).norm();
      if (!(distance < least)) continue;
      found = frame.ball->flight ? optics::WholeBall{seen.position} : whole(seen.position, image);
      least = distance;
    }
    if (!found || (chosen && chosen->camera == followed_)) continue;
    if (chosen && image.camera != followed_) continue;
    chosen = &image;
    ball = found->position - its.offset;
    sigma = found->shift * hidden_share + (1 / std::max(found->slope, 0.3) - 1) * 0.001;
  }
  const world::Time time = chosen ? chosen->t_capture : frame.time;
  if (count_ > 0) {  // two points at nearly one time tell nothing of velocities
    const TrailPoint& last = ring_[static_cast<std::size_t>(newest_)];
    if (time < last.time + least_step) {
      if (!chosen || last.seen || time <= last.time) return;
      newest_ = (newest_ + memory - 1) % memory;
      --count_;
    }
  }
  if (count_ > 0 && chosen) {
    const world::Duration hidden = time - seen_;
    if (hidden > longest_gap || (ball - seen_ball_).norm() > fastest * world::seconds(hidden) + slack)
      reset();
  }
  if (chosen) {
    seen_ = time;
    seen_ball_ = ball;
  }
  const bool is_news = count_ > 0 && !(ring_[static_cast<std::size_t>(newest_)].height > 0);
  if (frame.ball->flight && chosen && is_news) lift(*frame.ball->flight);
  TrailPoint& point = push();
  point.time = time;
  point.seen = chosen != nullptr;
  point.ball = ball;
  point.sigma = sigma;
  point.airborne = frame.ball->airborne;
  if (frame.ball->flight && chosen) {  // its place on the ground, not what the camera projects there
    point.height = frame.ball->position.z();
    point.ball = here + velocity * world::seconds(time - frame.time);
    point.sigma = flight_sigma;
  }
  point.told = told;
  point.probability = probability;
  if (chosen) {
    point.other_camera = count_ > 1 && chosen->camera != followed_;
    followed_ = chosen->camera;
    const Vector2d offset = camera(chosen->camera).offset;
    for (const world::DetectedRobot& robot : chosen->robots) {
      if (!robot.number || *robot.number > world::max_robot_number || !robot.orientation) continue;
      const Vector2d place = robot.position - offset;
      if (!((place - ball).squaredNorm() < near_robot * near_robot)) continue;
      if (point.robot_count == Sighting::most_robots) break;
      point.robots[point.robot_count++] = {slot({robot.team, *robot.number}), place, *robot.orientation};
    }
  }
  for (std::size_t n = 0; n < point.robot_count; ++n) {
    const Sighting::Robot& robot = point.robots[n];
    const double gap = hull_gap(world::rotated(ball - robot.position, -robot.orientation), geometry_.field);
    if (gap < -over_hull) point.under |= 1U << robot.slot;
  }
  const double ago = world::seconds(time - frame.time);
  for (const world::TrackedRobot& robot : frame.robots) {
    if (point.robot_count == Sighting::most_robots || robot.id.number > world::max_robot_number) break;
    const Vector2d there = robot.position + robot.velocity * ago;
    if (!((there - ball).squaredNorm() < near_robot * near_robot) || point.find(slot(robot.id))) continue;
    point.robots[point.robot_count++] = {slot(robot.id), there,
                                         robot.orientation + robot.angular_velocity * ago};
  }
}

}  // namespace touch

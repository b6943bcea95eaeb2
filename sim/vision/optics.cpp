#include "sim/vision/optics.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vision {

using world::Vector2d;
using world::Vector3d;

namespace {

constexpr double highest_share = 0.9;  // of the camera's height, that an object counts as being

}  // namespace

Vector2d pixel_of(const world::Camera& camera, const Vector3d& point) {
  const Vector3d from_camera = point - camera.position;
  const double scale = camera.focal_length / -from_camera.z();
  return {camera.image_width / 2.0 + scale * from_camera.x(),
          camera.image_height / 2.0 - scale * from_camera.y()};
}

double ball_area(const world::Camera& camera, const Vector3d& ball, double ball_radius) {
  const double nearest = std::max((1 - highest_share) * camera.position.z(), 2 * ball_radius);
  const double depth = std::max(camera.position.z() - ball.z(), nearest);
  const double beside = (ball - camera.position).head<2>().squaredNorm();
  const double r2 = ball_radius * ball_radius;
  const double across = depth * depth - r2;  // squared; so is what follows
  const double scaled = camera.focal_length * camera.focal_length * r2 / across;
  return std::numbers::pi * scaled * std::sqrt((beside + across) / across);
}

double ball_confidence(std::uint32_t area) {
  constexpr double least = 30, most = 40, variance = 100;  // [px], SSL-Vision's defaults
  const double excess = (area - std::clamp(static_cast<double>(area), least, most)) / variance;
  return std::exp(-excess * excess / 2);
}

Vector2d projected_to_ground(const Vector3d& camera, const Vector3d& ball, double ball_radius) {
  const double height = std::clamp(ball.z() - ball_radius, 0.0, highest_share * camera.z());
  if (height == 0) return ball.head<2>();  // to the bit
  return on_ball_plane(camera, {ball.x(), ball.y(), height + ball_radius}, ball_radius);
}

Vector2d on_ball_plane(const Vector3d& camera, const Vector3d& point, double ball_radius) {
  const Vector2d foot = camera.head<2>();
  return foot + (point.head<2>() - foot) * (camera.z() / (camera.z() - (point.z() - ball_radius)));
}

}  // namespace vision

#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "sim/truth/truth.h"
#include "sim/vision/area.h"
#include "sim/vision/bursts.h"
#include "sim/vision/draws.h"
#include "sim/vision/false_balls.h"
#include "sim/vision/occlusion.h"
#include "sim/vision/params.h"
#include "sim/vision/regions.h"
#include "sim/world/detection.h"
#include "sim/world/field.h"
#include "sim/world/random.h"

namespace vision {

/// One camera: what it reports of an image, with all its errors. A value that can be copied.
///
/// Every kind of error has a source of randomness of its own, named after the camera, so that neither a
/// change of one parameter nor what another camera sees shifts anything else.
class Eye {
 public:
  /// @param area  on the ground; objects in it are seen
  /// @param body  of every robot
  /// @param name  of the camera, first part of the names of its sources of randomness
  Eye(const world::Geometry& geometry, const world::Camera& camera, const Area& area, const Params& params,
      const world::RobotSpecs& body, std::uint64_t seed, const std::string& name);

  /// Fills camera, frame number, balls and robots of `out`; its times are left alone.
  void see(const truth::Ball& ball, std::span<const truth::Robot> robots, world::Detection& out);

 private:
  void see_ball(std::uint32_t image, const truth::Ball& ball, std::span<const truth::Robot> robots,
                world::Detection& out);
  void see_robots(std::uint32_t image, std::span<const truth::Robot> robots, world::Detection& out);
  void see_false_balls(std::uint32_t image, world::Detection& out);
  world::Vector2d error_at(const world::Vector2d& place) const;
  world::Vector2d ball_pixel(const world::Vector2d& place) const;

  world::Camera camera_;
  Area area_;
  Params params_;
  double ball_radius_, robot_height_;  // [m]
  std::uint32_t images_ = 0;           // taken so far

  world::Vector2d bias_;  // [m]
  Regions regions_;
  Occlusion occlusion_;
  Bursts bursts_;
  FalseBalls false_balls_;
  world::RandomStream noise_, loss_;
  Draws flicker_, area_noise_, ids_, false_ball_noise_;
  std::vector<const truth::Robot*> in_view_;  // of the present image
};

}  // namespace vision

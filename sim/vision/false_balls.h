#pragma once

#include <optional>
#include <span>
#include <vector>

#include "sim/truth/truth.h"
#include "sim/vision/area.h"
#include "sim/vision/draws.h"
#include "sim/vision/params.h"
#include "sim/world/robot_specs.h"

namespace vision {

/// What one camera takes for a ball and is none.
///
/// In each image one begins with probability rate / 60 and lasts a number of images uniform in
/// shortest..longest. Half of them lie on the top of a robot in view and move and turn with it, or anywhere
/// when no robot is in view; the other half lie anywhere in the camera's area. All is uniform: which robot,
/// where on it, where in the area, and how large the blob is, a quarter to the whole of a ball's disc.
class FalseBalls {
 public:
  struct Seen {
    world::Vector3d place;  ///< [m]
    double size;            ///< share of a ball's disc
    unsigned age;           ///< [images] since it began; tells those of one image apart
  };

  /// @param area  finite
  /// @param body  of every robot
  FalseBalls(const Params& params, const Area& area, double ball_radius, const world::RobotSpecs& body,
             Draws draws);

  /// Those of this image; call once for every image.
  /// @param in_view  robots in the camera's area
  const std::vector<Seen>& update(std::uint32_t image, std::span<const truth::Robot* const> in_view);

 private:
  struct FalseBall {
    std::uint32_t begin, end;  // [images]
    std::optional<world::RobotId> robot;
    world::Vector2d place;  // [m] local on the robot, or on the field
    double size;
  };
  FalseBall begin(std::uint32_t image, std::span<const truth::Robot* const> in_view) const;

  double probability_;  // that one begins in an image
  int shortest_, longest_;
  Area area_;
  double ball_radius_, robot_radius_, robot_height_;  // [m]
  Draws draws_;
  std::vector<FalseBall> alive_;
  std::vector<Seen> seen_;  // of the last image
};

}  // namespace vision

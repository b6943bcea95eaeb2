#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sim/truth/truth.h"
#include "sim/vision/params.h"
#include "sim/world/detection.h"
#include "sim/world/field.h"
#include "sim/world/random.h"

namespace vision {

/// The cameras above the field: truth in, detections as they are on the wire out.
///
/// Each camera has its own phase (see `captures_after`), its own area (`Area`), its own frame counter and its
/// own random streams, so that what one camera loses does not shift the noise of another.
class Cameras {
 public:
  /// @param seed  of the match; the streams are named "vision camera <index> ..."
  /// @throws std::invalid_argument  for no camera, a camera not above robot height, equal camera ids, a
  ///                                probability outside 0..1, a negative sigma, delay or overlap
  Cameras(const world::Geometry& geometry, const Params& params, std::uint64_t seed);

  /// Starts a tick: what was captured `Params::delay` ticks ago is forgotten after its delivery.
  void begin_tick();

  /// Takes the images of every camera whose phase is the end of `substep` (1..4) of the present tick.
  ///
  /// @param now     instant of the images; rounded to whole microseconds in the detections
  void capture(int substep, world::Time now, const truth::Ball& ball, std::span<const truth::Robot> robots);

  /// Says whether any camera takes an image after this substep (1..4).
  bool captures_after(int substep) const;

  /// What arrives at the end of the present tick, in the order of capture; empty in the first `delay` ticks.
  std::span<const world::Detection> delivered() const;

 private:
  struct Area {  // [m] on the ground; infinite towards the outside
    double min_x, max_x, min_y, max_y;
    bool contains(const world::Vector2d& point) const;
  };
  struct CameraState {
    world::Camera camera;
    Area area;
    int substep;  // 1..4
    std::uint32_t frame_number;
    world::RandomStream noise, loss;
  };
  struct Batch {  // the images of one tick; detections are reused, `count` of them are valid
    std::vector<world::Detection> detections;
    std::size_t count = 0;
  };

  void take_image(CameraState& camera, world::Time now, const truth::Ball& ball,
                  std::span<const truth::Robot> robots, world::Detection& out);

  Params params_;
  double ball_radius_ = 0;  // [m]
  std::vector<CameraState> cameras_;
  std::vector<Batch> batches_;  // ring of delay + 1 ticks
  std::size_t present_ = 0;     // batch of the present tick
};

/// Where the ball's centre appears on the ground: the ray from the camera through it, followed down.
///
/// For a camera at height H and a ball whose lowest point is at height z, g = c + (p - c) H / (H - z)
/// (reference "football", 3.3: heights are counted from the resting ball, as the league's calibration does).
/// Heights above 0.9 H count as 0.9 H (ER-Force simulator does the same), so the result stays finite.
world::Vector2d projected_to_ground(const world::Vector3d& camera, const world::Vector3d& ball,
                                    double ball_radius);

}  // namespace vision

#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sim/truth/truth.h"
#include "sim/vision/eye.h"
#include "sim/vision/optics.h"
#include "sim/vision/params.h"
#include "sim/world/detection.h"
#include "sim/world/field.h"
#include "sim/world/robot_specs.h"

namespace vision {

/// The cameras above the field: truth in, detections as they are on the wire out. A value that can be copied:
/// the copy goes on as the original does.
///
/// Each camera has its own phase (see `captures_after`), its own area, its own frame counter and its own
/// randomness, so that what one camera loses does not shift the noise of another.
class Cameras {
 public:
  /// @param seed  of the match; everything random is named "vision camera <index> ..."
  /// @param body  of every robot
  /// @throws std::invalid_argument  see check.h
  Cameras(const world::Geometry& geometry, const Params& params, std::uint64_t seed,
          const world::RobotSpecs& body = {});

  /// Starts a tick: what was captured `Params::delay` ticks ago is forgotten after its delivery.
  void begin_tick();

  /// Takes the images of every camera whose phase is the end of `substep` (1..4) of the present tick.
  ///
  /// @param now     instant of the images; rounded to whole microseconds in the detections
  /// @param robots  sorted by id
  /// @pre   robot numbers are at most 15
  void capture(int substep, world::Time now, const truth::Ball& ball, std::span<const truth::Robot> robots);

  /// Says whether any camera takes an image after this substep (1..4).
  bool captures_after(int substep) const;

  /// What arrives at the end of the present tick, in the order of capture; empty in the first `delay` ticks.
  std::span<const world::Detection> delivered() const;

 private:
  struct Phased {
    Eye eye;
    int substep;  // 1..4
  };
  struct Batch {  // the images of one tick; detections are reused, `count` of them are valid
    std::vector<world::Detection> detections;
    std::size_t count = 0;
  };

  world::Duration delay_{};
  std::vector<Phased> cameras_;
  std::vector<Batch> batches_;  // ring of delay + 1 ticks
  std::size_t present_ = 0;     // batch of the present tick
};

}  // namespace vision

#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "sim/world/tracked_frame.h"

namespace detectors {

/// Where robots were in the last half second: touches are reported late, with their own time.
class RobotPast {
 public:
  /// @pre frames come in order
  void add(const world::TrackedFrame& frame);
  void clear() { count_ = 0; }

  /// Where the robot's centre was [m], between two frames on the straight line; nothing when it was not known
  /// then, or the time is before the first frame kept. After the last frame: where it was in that.
  std::optional<world::Vector2d> position(world::RobotId robot, world::Time time) const;

 private:
  struct Sample {
    world::Time time;
    std::vector<std::pair<world::RobotId, world::Vector2d>> robots;
  };

  const Sample& newest(std::size_t back) const {
    return samples_[(next_ + samples_.size() - 1 - back) % samples_.size()];
  }

  std::array<Sample, 32> samples_;
  std::size_t next_ = 0;
  std::size_t count_ = 0;
};

}  // namespace detectors

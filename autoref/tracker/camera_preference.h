#pragma once

#include <cstdint>

#include "sim/world/time.h"

namespace tracker {

/// Which camera is believed about one object when two of them disagree.
///
/// Calibrated cameras differ from each other by centimetres, the same way for seconds (3.5 cm in the real log
/// of the tests). Between two images milliseconds apart this looks like metres per second. Sightings that
/// agree to `agreement` are all used. One that is further off counts only if it is from the camera that has
/// been following the object, until that camera was silent for 25 ms, one and a half frames.
class CameraPreference {
 public:
  static constexpr double agreement = 0.008;  ///< [m] ours: the gate of a followed robot (4 mm) with reserve

  /// True when a sighting of this camera that is off by more than `agreement` may be a matter of calibration.
  bool distrusts(int camera, world::Time time) const { return camera != home_ && time - seen_ <= patience; }
  /// A sighting was used.
  void used(int camera, world::Time time) {
    if (camera != home_ && time - seen_ <= patience) return;
    home_ = camera;
    seen_ = time;
  }

 private:
  static constexpr world::Duration patience = std::chrono::milliseconds{25};

  int home_ = -1;
  world::Time seen_{world::Duration{std::int64_t{-4} * 1000000000000000000}};
};

}  // namespace tracker

#pragma once

#include <array>

#include "sim/vision/draws.h"

namespace vision {

/// Losses that come in bursts: each object of one camera is, image by image, in one of
/// two states, seen or lost.
///
/// A seen object is lost with probability `start`, a lost one is seen again with probability 1 / length (a
/// Gilbert model), so bursts have geometric lengths of that mean. In the first image the chain is in its
/// stationary state: lost with probability start * length / (1 + start * length).
class Bursts {
 public:
  explicit Bursts(Draws draws) : draws_(draws) {}

  /// The object's state in this image; call once for every image, seen or not.
  /// @pre length >= 1
  bool lost(double start, double length, std::uint32_t image, unsigned object) {
    if (start == 0) return false;
    const double number = draws_.uniform(image, object);
    bool& lost = lost_[object];
    if (image == 0) {
      lost = number < start * length / (1 + start * length);
    } else {
      lost = lost ? number >= 1 / length : number < start;
    }
    return lost;
  }

 private:
  Draws draws_;
  std::array<bool, object_count> lost_{};
};

}  // namespace vision

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "autoref/calibrate/statistics.h"

namespace calibrate {

/// Sightings by the number of images missed after them: [0] none, [1] one, ...
struct Gaps {
  std::vector<std::int64_t> ended;  ///< until the next sighting
  std::vector<std::int64_t> open;   ///< at least; then nobody could tell any more

  void add(std::size_t missed, bool is_open = false);
  double seen() const;
  double missed() const;
};

/// Losses as single misses and bursts.
struct BurstFit {
  Estimate missing;     ///< probability of a miss outside bursts
  Estimate start;       ///< probability in one image that a burst begins; 0 when none is seen
  Estimate length;      ///< [images] mean length of a burst; without meaning when start is 0
  double evidence = 0;  ///< 2 ln(likelihood with bursts / without)
};

/// Two hidden states, "good" (missed with probability m) and "burst" (always missed): good goes to burst with
/// probability s, burst ends with probability 1/L, in each image. Largest likelihood of the gaps; errors from
/// its curvature. Bursts are believed when they raise the log-likelihood by 5 or more; without them m is
/// misses / images and the error of s is the bound 3 / images (95 %).
///
/// Source  E. N. Gilbert, "Capacity of a burst-noise channel", 1960.
/// @pre    gaps has a sighting
BurstFit fit_bursts(const Gaps& gaps);

}  // namespace calibrate

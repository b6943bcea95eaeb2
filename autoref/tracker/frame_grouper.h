#pragma once

#include <span>
#include <vector>

#include "sim/world/detection.h"

namespace tracker {

/// Turns a stream of single camera images (network, league log) into the batches that Tracker::update takes.
///
/// A batch is complete when a camera reports again. For a stream in which all cameras report every tick these
/// are exactly the host's batches; a silent camera only makes them smaller.
class FrameGrouper {
 public:
  /// @return the batch that this image completes, without the image itself; empty when none.
  ///         Valid until the next call.
  std::span<const world::Detection> add(const world::Detection& detection);

  /// What is left at the end of the stream; may be empty.
  std::span<const world::Detection> flush();

 private:
  bool has(int camera) const;

  std::vector<world::Detection> collecting_;  // the first `collected_` are in use, the rest keep their memory
  std::size_t collected_ = 0;
  std::vector<world::Detection> complete_;
};

}  // namespace tracker

#include "autoref/tracker/frame_grouper.h"

#include <algorithm>
#include <utility>

namespace tracker {
namespace {

constexpr std::size_t max_cameras = 64;  // ids beyond are nonsense; the league had 4 to 8

}  // namespace

bool FrameGrouper::has(int camera) const {
  const std::span<const world::Detection> images(collecting_.data(), collected_);
  return std::ranges::any_of(images, [camera](const world::Detection& d) { return d.camera == camera; });
}

std::span<const world::Detection> FrameGrouper::add(const world::Detection& detection) {
  std::span<const world::Detection> batch;
  if (has(detection.camera) || collected_ == max_cameras) batch = flush();
  if (collected_ == collecting_.size()) collecting_.emplace_back();
  collecting_[collected_++] = detection;
  return batch;
}

std::span<const world::Detection> FrameGrouper::flush() {
  std::swap(collecting_, complete_);
  return {complete_.data(), std::exchange(collected_, 0)};
}

}  // namespace tracker

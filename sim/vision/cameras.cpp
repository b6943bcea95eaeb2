#include "sim/vision/cameras.h"

#include <algorithm>
#include <limits>
#include <string>

#include "sim/vision/check.h"

namespace vision {
namespace {

// Beyond this difference two cameras stand in different columns or rows [m].
constexpr double different = 0.1;

// The middle between a camera and its nearest neighbour on the side `sign` of one axis, plus the overlap.
double limit(std::span<const world::Camera> cameras, const world::Camera& self, int axis, double sign,
             double overlap) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const world::Camera& other : cameras) {
    const double ahead = sign * (other.position[axis] - self.position[axis]);
    if (ahead > different) nearest = std::min(nearest, ahead);
  }
  return self.position[axis] + sign * (nearest / 2 + overlap);
}

}  // namespace

Cameras::Cameras(const world::Geometry& geometry, const Params& params, std::uint64_t seed,
                 const world::RobotSpecs& body) {
  check(geometry, params, body);
  delay_ = world::from_seconds(params.delay * world::tick_length);
  batches_.resize(static_cast<std::size_t>(params.delay) + 1);
  for (std::size_t i = 0; i < geometry.cameras.size(); ++i) {
    const world::Camera& camera = geometry.cameras[i];
    const auto edge = [&](int axis, double sign) {
      return limit(geometry.cameras, camera, axis, sign, params.overlap);
    };
    const Area area{edge(0, -1), edge(0, 1), edge(1, -1), edge(1, 1)};
    cameras_.push_back({Eye(geometry, camera, area, params, body, seed, "vision camera " + std::to_string(i)),
                        static_cast<int>(i) % world::substeps_per_tick + 1});
  }
  for (Batch& batch : batches_) batch.detections.resize(cameras_.size());
}

void Cameras::begin_tick() {
  present_ = (present_ + 1) % batches_.size();
  batches_[present_].count = 0;
}

bool Cameras::captures_after(int substep) const {
  return std::any_of(cameras_.begin(), cameras_.end(),
                     [&](const Phased& camera) { return camera.substep == substep; });
}

void Cameras::capture(int substep, world::Time now, const truth::Ball& ball,
                      std::span<const truth::Robot> robots) {
  Batch& batch = batches_[present_];
  for (Phased& camera : cameras_) {
    if (camera.substep != substep) continue;
    world::Detection& image = batch.detections[batch.count++];
    image.t_capture = world::whole_microseconds(now);
    image.t_sent = world::whole_microseconds(now + delay_);
    camera.eye.see(ball, robots, image);
  }
}

std::span<const world::Detection> Cameras::delivered() const {
  const Batch& oldest = batches_[(present_ + 1) % batches_.size()];
  return {oldest.detections.data(), oldest.count};
}

}  // namespace vision

#include "autoref/tracker/camera_bias.h"

#include <algorithm>
#include <cmath>

namespace tracker {
namespace {

constexpr double surprise = 3;          // sigmas; a larger difference counts as this
constexpr double walk = 0.0002;         // [m] in a frame: 12 mm/s beside true velocities; ours
constexpr double longest_pause = 60.0;  // [s] of drift at once; ours

double variance_of(double sigma) { return sigma * sigma; }

}  // namespace

CameraBias::CameraBias(const Params& params)
    : prior_(variance_of(params.bias_sigma)),
      drift_(variance_of(params.bias_drift)),
      local_(variance_of(params.local_sigma)),
      alone_(prior_),
      largest_(params.largest_bias),
      on_(params.bias_sigma > 0) {
  offsets_.reserve(most);
}

void CameraBias::reset() {
  offsets_.clear();
  covariance_.fill(0);
  alone_ = prior_;
}

const CameraBias::Offset* CameraBias::find(int camera) const {
  for (const Offset& offset : offsets_) {
    if (offset.camera == camera) return &offset;
  }
  return nullptr;
}

std::size_t CameraBias::index_of(int camera) {
  const auto found = std::ranges::find(offsets_, camera, &Offset::camera);
  const auto index = static_cast<std::size_t>(found - offsets_.begin());
  if (found != offsets_.end() || index == most) return index;
  offsets_.push_back({.camera = camera});
  cov(index, index) = alone_;  // as uncertain as the others were: the mean stays zero
  return index;
}

void CameraBias::compare(int camera, int other, const Vector2d& difference, double variance,
                         world::Time time) {
  if (!on_) return;
  const std::size_t a = index_of(camera);
  const std::size_t b = index_of(other);
  if (a == most || b == most || a == b) return;
  const std::size_t n = offsets_.size();

  const double pause = std::clamp(world::seconds(time - last_), 0.0, longest_pause);
  last_ = time;
  alone_ += drift_ * pause;
  for (std::size_t i = 0; i < n; ++i) cov(i, i) += drift_ * pause;

  std::array<double, most> with{};  // covariance of each offset with the difference
  for (std::size_t i = 0; i < n; ++i) with[i] = cov(i, a) - cov(i, b);
  const double s = with[a] - with[b] + variance + local_;
  const Vector2d expected = offsets_[a].estimate - offsets_[b].estimate;
  const double limit = surprise * std::sqrt(s);
  const Vector2d innovation = (difference - expected).cwiseMax(-limit).cwiseMin(limit);
  double largest = 0;
  for (std::size_t i = 0; i < n; ++i) {
    offsets_[i].estimate += with[i] / s * innovation;
    largest = std::max(largest, offsets_[i].estimate.cwiseAbs().maxCoeff());
    cov(i, i) -= with[i] * with[i] / s;
    for (std::size_t j = i + 1; j < n; ++j) {
      const double change = with[i] * with[j] / s;
      cov(i, j) -= change;
      cov(j, i) -= change;
    }
  }
  if (largest > largest_) {
    for (Offset& offset : offsets_) offset.estimate *= largest_ / largest;
  }
}

void CameraBias::advance() {
  double farthest = 0;
  for (const Offset& offset : offsets_) {
    farthest = std::max(farthest, (offset.estimate - offset.applied).cwiseAbs().maxCoeff());
  }
  if (farthest == 0) return;
  const double share = std::min(1.0, walk / farthest);  // one share for all: the mean stays zero
  for (Offset& offset : offsets_) offset.applied += share * (offset.estimate - offset.applied);
}

Vector2d CameraBias::applied(int camera) const {
  const Offset* offset = find(camera);
  return offset ? offset->applied : Vector2d(Vector2d::Zero());
}

Vector2d CameraBias::estimate(int camera) const {
  const Offset* offset = find(camera);
  return offset ? offset->estimate : Vector2d(Vector2d::Zero());
}

}  // namespace tracker

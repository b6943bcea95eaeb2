#include "autoref/tracker/air_filter.h"

#include <algorithm>
#include <cmath>

#include "sim/world/time.h"

namespace tracker {
namespace {

constexpr double g = 9.81;  // [m/s^2]
// [m^2/s^3] as of a rolling ball: drag and calibration; ours
constexpr double noise = 0.15 * 0.15 * world::tick_length;
constexpr double height_sigma = 0.003;  // [m] of the kick's place; ours
constexpr double speed_sigma = 4.0;     // [m/s] per axis; kickers give up to 8
constexpr double usual_rise = 3.0;      // [m/s] of a chip kick at its start: 45 degrees of 4.2 m/s
constexpr double rise_sigma = 1.5;      // [m/s]
constexpr double restitution = 0.5;     // of the vertical speed: .47 to .57 (football.md 5)
constexpr double first_keep = 5.0 / 7;  // of the horizontal speed: .71 (football.md 5), a sphere that grips
constexpr double later_keep = 0.9;      // .85 (TIGERs) to 1, a ball that rolls already
constexpr double keep_sigma = 0.08;     // share of the speed
constexpr double cover_sigma = 0.5;     // [m/s] per axis after a bounce on a robot, which moves; ours
constexpr double lowest_hop = 0.010;    // [m] lower ones are rolling (football.md 3.3)
constexpr double highest_share = 0.9;   // of the camera's height, beyond which nothing is seen

}  // namespace

AirFilter::AirFilter(const Vector2d& from, double sigma) {
  x_ << from.x(), 0, from.y(), 0, 0, usual_rise;
  p_.setZero();
  p_.diagonal() << sigma * sigma, speed_sigma * speed_sigma, sigma * sigma, speed_sigma * speed_sigma,
      height_sigma * height_sigma, rise_sigma * rise_sigma;
}

AirFilter::AirFilter(const Vector3d& place, double sigma) : AirFilter(Vector2d(place.head<2>()), sigma) {
  x_[4] = place.z();
  x_[5] = 0;
  p_(4, 4) = sigma * sigma;
  p_(5, 5) = usual_rise * usual_rise;
}

void AirFilter::strike() {
  for (int i = 1; i < 6; i += 2) {
    p_.row(i).setZero();
    p_.col(i).setZero();
  }
  p_(1, 1) = p_(3, 3) = speed_sigma * speed_sigma;
  p_(5, 5) = rise_sigma * rise_sigma;
  rolls_ = false;
}

void AirFilter::bounce_on(double height) {
  const double below = height - x_[4];
  bounce();
  x_[4] = height + restitution * std::max(0.0, below);
  rolls_ = false;
  p_(4, 4) = std::max(p_(4, 4), height_sigma * height_sigma);
  for (int i = 1; i < 6; i += 2) p_(i, i) += cover_sigma * cover_sigma;
}

void AirFilter::fly(double dt) {
  for (int i = 0; i < 6; i += 2) x_[i] += x_[i + 1] * dt;
  x_[4] -= g / 2 * dt * dt;
  x_[5] -= g * dt;
  for (int i = 0; i < 6; i += 2) p_.row(i) += dt * p_.row(i + 1);
  for (int i = 0; i < 6; i += 2) p_.col(i) += dt * p_.col(i + 1);
  for (int i = 0; i < 6; i += 2) {
    p_(i, i) += noise * dt * dt * dt / 3;
    p_(i, i + 1) += noise * dt * dt / 2;
    p_(i + 1, i) += noise * dt * dt / 2;
    p_(i + 1, i + 1) += noise * dt;
  }
}

void AirFilter::bounce() {
  const double fall = -x_[5];
  const double keep = bounces_ == 0 ? first_keep : later_keep;
  ++bounces_;
  // An error of height at the impact is one of its instant: (1 - keep) v differs for so long.
  if (fall > 0) {
    for (int i = 0; i < 4; i += 2) {
      const double lever = (1 - keep) * x_[i + 1] / fall;
      p_.row(i) += lever * p_.row(4);
      p_.col(i) += lever * p_.col(4);
    }
  }
  const Eigen::Matrix<double, 6, 1> scale{1, keep, 1, keep, -restitution, -restitution};
  p_ = scale.asDiagonal() * p_ * scale.asDiagonal();
  const double speed_variance = keep_sigma * keep_sigma * (x_[1] * x_[1] + x_[3] * x_[3]);
  x_[1] *= keep;
  x_[3] *= keep;
  x_[5] = restitution * fall;
  x_[4] = 0;
  p_(1, 1) += speed_variance;
  p_(3, 3) += speed_variance;
  p_(5, 5) += keep_sigma * keep_sigma * fall * fall;
  if (x_[5] * x_[5] >= 2 * g * lowest_hop) return;
  rolls_ = true;
  x_[5] = 0;
  for (const int i : {4, 5}) {
    p_.row(i).setZero();
    p_.col(i).setZero();
  }
}

void AirFilter::predict(double dt) {
  while (dt > 0) {
    if (rolls_) {
      x_[0] += x_[1] * dt;
      x_[2] += x_[3] * dt;
      return;
    }
    // The end of this hop: z + v t - g t^2 / 2 = 0.
    const double root = std::sqrt(std::max(0.0, x_[5] * x_[5] + 2 * g * std::max(0.0, x_[4])));
    const double hop = (x_[5] + root) / g;
    const double step = std::clamp(hop, 0.0, dt);
    fly(step);
    dt -= step;
    if (hop <= step) bounce();
  }
}

AirFilter::Fit AirFilter::update(const Vector2d& seen, const Vector3d& camera, double r) {
  const Vector2d slant = (seen - camera.head<2>()) / camera.z();
  const double above = std::clamp(x_[4] / camera.z(), 0.0, highest_share);
  const double variance = r * (1 - above) * (1 - above);
  Fit fit;
  for (int axis = 0; axis < 2; ++axis) {
    const int i = 2 * axis;
    const Eigen::Matrix<double, 6, 1> with = p_.col(i) + slant[axis] * p_.col(4);
    const double s = with[i] + slant[axis] * with[4] + variance;
    const double innovation = seen[axis] - x_[i] - slant[axis] * x_[4];
    x_ += with * (innovation / s);
    p_ -= with * (with / s).transpose();
    fit.nis += innovation * innovation / s;
    fit.log_det += std::log(s / r);
  }
  return fit;
}

double AirFilter::nis(const Vector2d& seen, const Vector3d& camera, double r) const {
  AirFilter copy = *this;
  return copy.update(seen, camera, r).nis;
}

Vector2d AirFilter::seen_from(const Vector3d& camera) const {
  const double above = std::clamp(x_[4] / camera.z(), 0.0, highest_share);
  return camera.head<2>() + (position() - camera).head<2>() / (1 - above);
}

double AirFilter::sigma() const { return std::sqrt(std::max(p_(0, 0), p_(2, 2))); }

}  // namespace tracker

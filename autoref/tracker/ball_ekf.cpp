#include "autoref/tracker/ball_ekf.h"

#include <cmath>
#include <numbers>

namespace tracker {

void BallEkf::predict(double dt, const BallModel& model) {
  const double a = model.deceleration;
  const double speed = velocity.norm();

  Matrix2d vv;  // d(velocity after) / d(velocity before)
  Matrix2d pv;  // d(position after) / d(velocity before) [s]
  if (a * dt < speed || a == 0) {
    const double k = a > 0 ? a * dt / speed : 0;
    const Vector2d u = speed > 0 ? Vector2d(velocity / speed) : Vector2d(Vector2d::Zero());
    vv = (1 - k) * Matrix2d::Identity() + k * u * u.transpose();
    pv = (Matrix2d::Identity() + vv) * (dt / 2);
    position += velocity * ((1 - k / 2) * dt);
    velocity *= 1 - k;
  } else {  // it comes to rest after speed/a, having gone speed^2/2a
    const double half_time = speed / (2 * a);
    vv.setZero();
    pv.setZero();
    if (speed > 0)
      pv = half_time * (Matrix2d::Identity() + velocity * velocity.transpose() / (speed * speed));
    position += velocity * half_time;
    velocity.setZero();
  }

  const double q = model.noise;
  position_cov +=
      pv * cross_cov.transpose() + cross_cov * pv.transpose() + pv * velocity_cov * pv.transpose();
  cross_cov = ((cross_cov + pv * velocity_cov) * vv.transpose()).eval();
  velocity_cov = (vv * velocity_cov * vv.transpose()).eval();
  position_cov.diagonal().array() += q * dt * dt * dt / 3;
  cross_cov.diagonal().array() += q * dt * dt / 2;
  velocity_cov.diagonal().array() += q * dt;
}

double BallEkf::update(const Vector2d& measured, double r) {
  const Vector2d innovation = measured - position;
  Matrix2d s = position_cov;
  s.diagonal().array() += r;
  const double det = s(0, 0) * s(1, 1) - s(0, 1) * s(1, 0);
  Matrix2d s_inverse;
  s_inverse << s(1, 1), -s(0, 1), -s(1, 0), s(0, 0);
  s_inverse /= det;

  const double nis = innovation.dot(s_inverse * innovation);
  const Matrix2d position_gain = position_cov * s_inverse;
  const Matrix2d velocity_gain = cross_cov.transpose() * s_inverse;
  position += position_gain * innovation;
  velocity += velocity_gain * innovation;
  velocity_cov -= velocity_gain * cross_cov;
  cross_cov -= (position_gain * cross_cov).eval();
  // (I - K) P = r K exactly; this form keeps it symmetric and positive.
  position_cov = r / 2 * (position_gain + position_gain.transpose());
  velocity_cov = (velocity_cov + velocity_cov.transpose().eval()) / 2;
  return std::exp(-nis / 2) / (2 * std::numbers::pi * std::sqrt(det));
}

double normalised_square(const Vector2d& d, const Matrix2d& s) {
  const double det = s(0, 0) * s(1, 1) - s(0, 1) * s(1, 0);
  return (s(1, 1) * d.x() * d.x() - (s(0, 1) + s(1, 0)) * d.x() * d.y() + s(0, 0) * d.y() * d.y()) / det;
}

}  // namespace tracker

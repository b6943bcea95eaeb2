#include "sim/server/wheels.h"

#include <Eigen/QR>
#include <array>
#include <cmath>

namespace server {

std::optional<LocalMotion> motion(const wire::WheelAngles& angles, const wire::WheelSpeeds& speeds,
                                  double radius) {
  const std::array<double, 4> a = {angles.front_right, angles.back_right, angles.back_left,
                                   angles.front_left};
  Eigen::Matrix<double, 4, 3> rims;  // of (vx, vy, radius * w): of one size, so that the rank can be judged
  for (int wheel = 0; wheel < 4; ++wheel) {
    const double angle = a[static_cast<std::size_t>(wheel)];
    rims.row(wheel) << std::sin(angle), std::cos(angle), 1;
  }
  Eigen::ColPivHouseholderQR<Eigen::Matrix<double, 4, 3>> solver(rims);
  // Wheels within about 2 degrees of not deciding a direction would turn small speeds into large ones.
  solver.setThreshold(0.02);
  if (solver.rank() < 3) return std::nullopt;
  const Eigen::Vector4d s(speeds.front_right, speeds.back_right, speeds.back_left, speeds.front_left);
  const Eigen::Vector3d solution = solver.solve(s);
  return LocalMotion{solution.head<2>(), solution.z() / radius};
}

}  // namespace server

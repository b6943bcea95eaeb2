#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sim/world/geometry.h"
#include "sim/world/robot_id.h"
#include "sim/world/time.h"

namespace world {

/// One ball candidate in one camera image, projected to the ground plane.
struct DetectedBall {
  Vector2d position = Vector2d::Zero();  ///< [m] of a float of millimetres
  double confidence = 1;                 ///< 0..1
  std::uint32_t area = 0;                ///< [px]
  Vector2d pixel = Vector2d::Zero();     ///< [px]
};

/// One robot pattern in one camera image.
struct DetectedRobot {
  Team team{};
  std::optional<std::uint8_t> number;    ///< nothing when the pattern was not identified
  Vector2d position = Vector2d::Zero();  ///< [m] of a float of millimetres
  std::optional<double> orientation;     ///< [rad] of a float; nothing when it could not be determined
  double confidence = 1;
  Vector2d pixel = Vector2d::Zero();  ///< [px]
};

/// What one camera reports of one image: the only thing teams and referee see of the world.
///
/// Every number here has passed through the wire's types (float millimetres, whole microseconds), so that a
/// reader of the log sees the same bits as a listener inside the host.
struct Detection {
  int camera = 0;
  std::uint32_t frame_number = 0;
  Time t_capture;  ///< whole microseconds
  Time t_sent;     ///< whole microseconds
  std::vector<DetectedBall> balls;
  std::vector<DetectedRobot> robots;
};

/// A number as it comes back from the wire's float.
///
/// Never write the two casts out: g++ 12.2 at -O2 joins two neighbouring ones into one vector operation and
/// drops the rounding (it does so in `{as_on_wire(x), as_on_wire(y)}`); volatile keeps it.
inline double as_float(double value) {
  const volatile float rounded = static_cast<float>(value);
  return static_cast<double>(rounded);
}

/// A length in metres as it comes back from the wire's float of millimetres.
inline double as_on_wire(double metres) { return as_float(metres * 1000.0) / 1000.0; }
inline Vector2d as_on_wire(const Vector2d& metres) {
  return {as_on_wire(metres.x()), as_on_wire(metres.y())};
}

}  // namespace world

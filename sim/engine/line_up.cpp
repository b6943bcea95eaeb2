#include "sim/engine/line_up.h"

#include <numbers>

namespace engine {

std::vector<Pose> line_up(const world::Field& field, world::Side side, std::size_t count) {
  // Written for the half of negative x, then turned by half a turn if needed. The spacing scales with the
  // field (1 m between robots on 9 m by 6 m), so that it fits on any.
  const double step_x = field.length / 9;
  const double step_y = field.width / 6;
  const double columns[] = {0, 1, -1, 2, -2};  // in the order they are filled
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < count; ++i) {
    world::Vector2d position{-field.half_length() + field.robot_radius, 0};
    if (i > 0) {
      const std::size_t row = (i - 1) / 5;
      position = {-step_x * (1 + static_cast<double>(row)), step_y * columns[(i - 1) % 5]};
    }
    if (side == world::Side::Positive) position = -position;
    poses.push_back({position, side == world::Side::Positive ? std::numbers::pi : 0});
  }
  return poses;
}

}  // namespace engine

#pragma once

#include <array>
#include <span>

#include "teams/reference/situation.h"
#include "teams/skills/order.h"

namespace reference {

using world::Vector2d;

/// A part of the field to choose a place from [m].
struct Region {
  double x_low = 0, x_high = 0, y_low = 0, y_high = 0;
};

/// Where support number `index` of `count` looks for a place: the field ahead of the ball cut into bands of
/// y.
Region support_region(const kit::View& view, int index, int count);

/// How good it is to wait for a pass at that point [0..1]: the pass arrives, and something can be made of it.
double support_value(const kit::View& view, const Situation& situation, const Vector2d& point, int robot);

/// Supporters wait where a pass would be worth most. Thinks at 4 Hz for each robot, staggered.
class Supports {
 public:
  skills::Order play(const kit::View& view, const Situation& situation, const kit::Robot& robot, int index,
                     int count);

 private:
  std::array<std::optional<Vector2d>, world::max_robot_number + 1> places_;
};

}  // namespace reference

#include "teams/reference/defense.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace reference {

Vector2d wall_position(const kit::View& view, int index, int count) {
  const world::Field& field = view.field();
  const Vector2d goal = view.own_goal();
  Vector2d to_ball = view.ball.position - goal;
  if (to_ball.x() < 0.1) to_ball.x() = 0.1;
  const Vector2d along = to_ball.normalized();
  const double clear = field.robot_radius + 0.06;  // [m] hull outside the line, with room for the steering
  // Out along the line until outside the area.
  double s = 0.5;
  for (int i = 0; i < 30; ++i) {
    // The distance grows by at most a metre per metre, so this step never goes too far.
    const double missing =
        clear - world::distance_to_defense_area(field, world::Side::Negative, goal + s * along);
    if (missing <= 0.005) break;
    s += missing;
  }
  const double spacing = 2 * field.robot_radius + 0.03;
  const double beside = (index - 0.5 * (count - 1)) * spacing;
  const Vector2d across(-along.y(), along.x());
  return world::moved_out_of_defense_area(field, world::Side::Negative, goal + s * along + beside * across,
                                          clear);
}

double threat_time(const kit::View& view, const kit::Robot& opponent) {
  const Vector2d goal = view.own_goal();
  const Vector2d to_goal = goal - opponent.position;
  const Vector2d to_ball = view.ball.position - opponent.position;
  const double turn = std::abs(world::wrap_angle(world::angle_of(to_goal) - world::angle_of(to_ball)));
  const double deflection = std::clamp((turn - M_PI / 4) / (M_PI / 4), 0.0, 1.0);
  return to_ball.norm() / 4.0 + 0.5 * deflection + to_goal.norm() / 6.5;
}

Vector2d mark_position(const kit::View& view, const kit::Robot& opponent) {
  const Vector2d position = opponent.position + 0.2 * opponent.velocity;
  const Vector2d to_goal = (view.own_goal() - position).normalized();
  const Vector2d to_ball = (view.ball.position - position).normalized();
  // Goal side, and a little into the pass.
  return position + 0.4 * (0.75 * to_goal + 0.25 * to_ball);
}

skills::Order play_defender(const kit::View& view, const Situation& situation, const kit::Robot& robot,
                            int index, int count) {
  skills::Order order;
  order.heading = world::angle_of(view.ball.position - robot.position);
  order.ball_distance = 0.1;

  // One man in the wall for three, two above; the rest marks.
  const int wall = count <= 1 ? 1 : count == 2 ? (view.ball.position.x() < 0 ? 2 : 1) : 2;
  const int markers = count - wall;
  // The side of the ball builds the wall, the far side marks.
  // -0.15: not at the centre line, where the ball lies still at kickoffs and noise would decide.
  const bool ball_left = view.ball.position.y() > -0.15;
  const int from_ball_side = ball_left ? count - 1 - index : index;
  if (from_ball_side < wall || markers <= 0) {
    order.why = "wall";
    const int place = ball_left ? wall - 1 - from_ball_side : from_ball_side;
    order.target = wall_position(view, place, wall);
    return order;
  }
  // The worst threats in order, but for the one at the ball.
  struct Threat {
    double time = 0;
    const kit::Robot* robot = nullptr;
  };
  std::array<Threat, 16> threats;
  std::size_t found = 0;
  for (const kit::Robot& opponent : view.opponents) {
    if (opponent.number == situation.their_first || opponent.number == view.game.their_keeper) continue;
    if (opponent.position.x() > 1.0 || found == threats.size()) continue;
    threats[found++] = {threat_time(view, opponent), &opponent};
  }
  std::sort(threats.begin(), threats.begin() + static_cast<std::ptrdiff_t>(found),
            [](const auto& a, const auto& b) {
              return a.time != b.time ? a.time < b.time : a.robot->number < b.robot->number;
            });
  const auto rank = static_cast<std::size_t>(from_ball_side - wall);
  if (rank < found) {
    order.why = "mark";
    order.target = mark_position(view, *threats[rank].robot);
    return order;
  }
  order.why = "cover";
  // Nobody to mark: in front of the middle, ready for the second ball.
  order.target = 0.5 * (view.own_goal() + view.ball.position);
  order.target.x() = std::min(order.target.x(), -1.0);
  order.target.y() *= 0.5;
  return order;
}

}  // namespace reference

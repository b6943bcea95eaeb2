#include "teams/reference/support.h"

#include <algorithm>

#include "teams/reference/choose_kick.h"
#include "teams/skills/pass.h"

namespace reference {
namespace {

constexpr int think_every = 15;  // ticks
constexpr double keep = 0.03;    // of value, in favour of the place before

}  // namespace

Region support_region(const kit::View& view, int index, int count) {
  const world::Field& field = view.field();
  const double ball_x = view.ball.position.x();
  Region region;
  region.x_high = field.half_length() - 0.5;
  region.x_low = std::clamp(ball_x - 0.5, -1.5, field.half_length() - 3.0);
  region.x_high = std::min(region.x_high, std::max(ball_x + 4.5, 1.0));
  const double inner = field.half_width() - 0.4;
  const double band = 2 * inner / std::max(count, 1);
  region.y_low = -inner + band * index;
  region.y_high = region.y_low + band;
  if (count == 1) {
    // Alone: on the side the ball is not.
    if (view.ball.position.y() > 0) {
      region.y_high = 0.5;
    } else {
      region.y_low = -0.5;
    }
  }
  return region;
}

double support_value(const kit::View& view, const Situation& situation, const Vector2d& point, int robot) {
  const Vector2d ball = view.ball.position;
  const double length = (point - ball).norm();
  if (length < 1.0) return 0;
  const skills::Pass pass = skills::plan_pass(view, situation.model, ball, point);
  const double reachable = length < 5.5 ? 1.0 : 0.5;
  return (0.3 + 0.7 * pass.safety) * reachable * value_at(view, point, robot);
}

skills::Order Supports::play(const kit::View& view, const Situation& situation, const kit::Robot& robot,
                             int index, int count) {
  std::optional<Vector2d>& place = places_[robot.number];
  const Region region = support_region(view, index, count);
  const auto inside = [&region](const Vector2d& p) {
    return p.x() >= region.x_low - 0.3 && p.x() <= region.x_high + 0.3 && p.y() >= region.y_low - 0.3 &&
           p.y() <= region.y_high + 0.3;
  };
  if (place && !inside(*place)) place.reset();
  if (!place || (view.tick + 5 * robot.number) % think_every == 0) {
    double best = -1;
    Vector2d chosen = robot.position;
    const auto consider = [&](const Vector2d& point, double bonus) {
      if (world::distance_to_defense_area(view.field(), world::Side::Positive, point) < 0.35) return;
      double value = support_value(view, situation, point, robot.number) + bonus;
      for (const kit::Robot& mate : view.own) {
        if (mate.number != robot.number && (mate.position - point).norm() < 0.8) value -= 0.1;
      }
      if (value <= best) return;
      best = value;
      chosen = point;
    };
    if (place) consider(*place, keep);
    constexpr int columns = 3;
    constexpr int rows = 3;
    for (int i = 0; i < columns; ++i) {
      for (int j = 0; j < rows; ++j) {
        consider({region.x_low + (region.x_high - region.x_low) * (i + 0.5) / columns,
                  region.y_low + (region.y_high - region.y_low) * (j + 0.5) / rows},
                 0);
      }
    }
    place = chosen;
  }
  skills::Order order;
  order.why = "support";
  order.target = *place;
  order.heading = world::angle_of(view.ball.position - robot.position);
  order.ball_distance = 0.15;
  order.their_area = 0.1;
  return order;
}

}  // namespace reference

#include "teams/reference/value_map.h"

namespace reference {
namespace {

constexpr int slices_in_a_hurry = 12;  // ticks: 5 Hz
constexpr int slices_else = 18;

}  // namespace

bool may_wait_at(const kit::View& view, const Vector2d& point) {
  // 0.2 m: the distance the laws ask of the attackers until a free kick is taken; 0.05 for the steering.
  return world::distance_to_defense_area(view.field(), world::Side::Positive, point) >
         view.field().robot_radius + 0.25;
}

const ValueMap::Point& ValueMap::at(int index) const { return known_as_far_as(Known::Value, index); }

void ValueMap::find_out(Known wanted, std::size_t index) const {
  Entry& entry = entries_[index];
  Known& known = known_[index];
  const Moment& moment = moments_[moment_of_[index]];
  const kit::View& view = moment.view;
  Point& point = entry.point;
  if (known == Known::Nothing) {
    point.position = moment.partition.grid_point(static_cast<int>(index));
    const Reception best_case = best_case_at(view, view.ball.position, point.position);
    entry.open = best_case.goal;
    point.value = best_case.value();
    known = Known::Bound;
  }
  if (known < wanted && known == Known::Bound) {
    if (!may_wait_at(view, point.position)) {
      point.value = 0;
      known = Known::Value;
      return;
    }
    entry.least = pass_at(view, moment.model, view.ball.position, point.position);
    point.ball_time = entry.least.ball_time;
    Reception open = entry.least;
    open.goal = entry.open;
    point.value = open.value();
    known = Known::Pass;
  }
  if (known < wanted) {
    entry.least.goal = goal_after(view, point.position, entry.least);
    point.value = entry.least.value();
    known = Known::Value;
  }
}

// The place of the oldest moment is taken. A point that still waits for it (its turn did not come, because
// the ticks were not consecutive or the rhythm changed) is worked out now.
void ValueMap::remember(const kit::View& view, const kit::BallModel& model, const Partition& partition) {
  now_ = static_cast<std::uint8_t>((now_ + 1U) % moments_.size());
  if (begun_) {
    for (std::size_t i = 0; i < grid_points; ++i) {
      if (moment_of_[i] == now_ && known_[i] < Known::Value) find_out(Known::Value, i);
    }
  }
  // All of the view but its geometry, which stays what it was.
  Moment& moment = moments_[now_];
  moment.view.tick = view.tick;
  moment.view.time = view.time;
  moment.view.ball = view.ball;
  moment.view.own = view.own;
  moment.view.opponents = view.opponents;
  moment.view.game = view.game;
  moment.model = model;
  moment.partition = partition;
}

void ValueMap::refresh(const kit::View& view, const kit::BallModel& model, const Partition& partition,
                       bool hurry) {
  if (!begun_) return compute(view, model, partition);
  remember(view, model, partition);
  const auto slices = static_cast<std::size_t>(hurry ? slices_in_a_hurry : slices_else);
  for (std::size_t i = static_cast<std::size_t>(view.tick) % slices; i < grid_points; i += slices) forget(i);
}

void ValueMap::compute(const kit::View& view, const kit::BallModel& model, const Partition& partition) {
  for (Moment& moment : moments_) moment.view.geometry = view.geometry;
  remember(view, model, partition);
  for (std::size_t i = 0; i < grid_points; ++i) forget(i);
  begun_ = true;
}

}  // namespace reference

#include "teams/reference/value_map.h"

namespace reference {
namespace {

constexpr int slices_in_a_hurry = 6;  // ticks: 10 Hz
constexpr int slices_else = 18;

}  // namespace

bool may_wait_at(const kit::View& view, const Vector2d& point) {
  // 0.2 m: the distance the laws ask of the attackers until a free kick is taken; 0.05 for the steering.
  return world::distance_to_defense_area(view.field(), world::Side::Positive, point) >
         view.field().robot_radius + 0.25;
}

const ValueMap::Point& ValueMap::at(int index) const { return known_as_far_as(Known::Value, index); }

void ValueMap::find_out(Known wanted, int index) const {
  Entry& entry = entries_[static_cast<std::size_t>(index)];
  const Moment& moment = moments_[entry.moment];
  const kit::View& view = moment.view;
  Point& point = entry.point;
  if (entry.known == Known::Nothing) {
    point.position = moment.partition.grid_point(index);
    const Reception best_case = best_case_at(view, view.ball.position, point.position);
    entry.open = best_case.goal;
    point.value = best_case.value();
    entry.known = Known::Bound;
  }
  if (entry.known < wanted && entry.known == Known::Bound) {
    if (!may_wait_at(view, point.position)) {
      point.value = 0;
      entry.known = Known::Value;
      return;
    }
    entry.least = pass_at(view, moment.model, view.ball.position, point.position);
    point.ball_time = entry.least.ball_time;
    Reception open = entry.least;
    open.goal = entry.open;
    point.value = open.value();
    entry.known = Known::Pass;
  }
  if (entry.known < wanted) {
    entry.least.goal = goal_after(view, point.position, entry.least);
    point.value = entry.least.value();
    entry.known = Known::Value;
  }
}

// The place of the oldest moment is taken. A point that still waits for it (its turn did not come, because
// the ticks were not consecutive or the rhythm changed) is worked out now.
void ValueMap::remember(const kit::View& view, const kit::BallModel& model, const Partition& partition) {
  now_ = static_cast<std::uint8_t>((now_ + 1U) % moments_.size());
  if (begun_) {
    for (int i = 0; i < grid_points; ++i) {
      if (entries_[static_cast<std::size_t>(i)].moment == now_) known_as_far_as(Known::Value, i);
    }
  }
  Moment& moment = moments_[now_];
  moment.view = view;
  moment.model = model;
  moment.partition = partition;
}

void ValueMap::refresh(const kit::View& view, const kit::BallModel& model, const Partition& partition,
                       bool hurry) {
  if (!begun_) return compute(view, model, partition);
  remember(view, model, partition);
  const int slices = hurry ? slices_in_a_hurry : slices_else;
  for (int i = static_cast<int>(view.tick % slices); i < grid_points; i += slices) {
    Entry& entry = entries_[static_cast<std::size_t>(i)];
    entry.known = Known::Nothing;
    entry.moment = now_;
  }
}

void ValueMap::compute(const kit::View& view, const kit::BallModel& model, const Partition& partition) {
  remember(view, model, partition);
  for (Entry& entry : entries_) {
    entry.known = Known::Nothing;
    entry.moment = now_;
  }
  begun_ = true;
}

}  // namespace reference

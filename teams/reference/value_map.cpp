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

const ValueMap::Moment& ValueMap::moment_of(int index) const {
  return moments_[static_cast<std::size_t>(waits_for_[static_cast<std::size_t>(index)])];
}

void ValueMap::evaluate(int index) const {
  const Moment& moment = moment_of(index);
  const kit::View& view = moment.view;
  Point& point = points_[static_cast<std::size_t>(index)];
  waits_for_[static_cast<std::size_t>(index)] = known;
  point.position = moment.partition.grid_point(index);
  point.value = 0;
  if (!may_wait_at(view, point.position)) return;
  const Reception reception = reception_at(view, moment.model, view.ball.position, point.position);
  point.value = reception.value();
  point.ball_time = reception.ball_time;
}

const ValueMap::Point& ValueMap::at(int index) const {
  if (waits_for_[static_cast<std::size_t>(index)] != known) evaluate(index);
  return points_[static_cast<std::size_t>(index)];
}

Vector2d ValueMap::position(int index) const {
  if (waits_for_[static_cast<std::size_t>(index)] == known) {
    return points_[static_cast<std::size_t>(index)].position;
  }
  return moment_of(index).partition.grid_point(index);
}

double ValueMap::most(int index) const {
  if (waits_for_[static_cast<std::size_t>(index)] == known) {
    return points_[static_cast<std::size_t>(index)].value;
  }
  const Moment& moment = moment_of(index);
  return most_at(moment.view, moment.view.ball.position, moment.partition.grid_point(index));
}

// The place of the oldest moment is taken. A point that still waits for it (its turn did not come, because
// the ticks were not consecutive or the rhythm changed) is worked out now.
void ValueMap::remember(const kit::View& view, const kit::BallModel& model, const Partition& partition) {
  now_ = (now_ + 1) % static_cast<int>(moments_.size());
  if (begun_) {
    for (int i = 0; i < grid_points; ++i) {
      if (waits_for_[static_cast<std::size_t>(i)] == now_) evaluate(i);
    }
  }
  Moment& moment = moments_[static_cast<std::size_t>(now_)];
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
    waits_for_[static_cast<std::size_t>(i)] = static_cast<std::int8_t>(now_);
  }
}

void ValueMap::compute(const kit::View& view, const kit::BallModel& model, const Partition& partition) {
  remember(view, model, partition);
  waits_for_.fill(static_cast<std::int8_t>(now_));
  begun_ = true;
}

}  // namespace reference

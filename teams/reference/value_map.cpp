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

void ValueMap::evaluate(const kit::View& view, const kit::BallModel& model, const Partition& partition,
                        int index) {
  Point& point = points_[static_cast<std::size_t>(index)];
  point.position = partition.grid_point(index);
  point.value = 0;
  if (!may_wait_at(view, point.position)) return;
  const Reception reception = reception_at(view, model, view.ball.position, point.position);
  point.value = reception.value();
  point.ball_time = reception.ball_time;
}

void ValueMap::refresh(const kit::View& view, const kit::BallModel& model, const Partition& partition,
                       bool hurry) {
  if (!begun_) return compute(view, model, partition);
  const int slices = hurry ? slices_in_a_hurry : slices_else;
  const int slice = static_cast<int>(view.tick % slices);
  for (int i = slice; i < grid_points; i += slices) evaluate(view, model, partition, i);
}

void ValueMap::compute(const kit::View& view, const kit::BallModel& model, const Partition& partition) {
  for (int i = 0; i < grid_points; ++i) evaluate(view, model, partition, i);
  begun_ = true;
}

}  // namespace reference

#include "teams/reference/places.h"

#include <algorithm>
#include <numeric>

#include "teams/skills/motion.h"

namespace reference {
namespace {

constexpr double keep = 0.03;   // of value, in favour of the place before
constexpr double apart = 1.0;   // [m] between greedy supporters (reference "football", 2.10)
constexpr double settle = 0.3;  // [s] in favour of the zone before

// The better of a place and a grid point; of equals the one with the smaller index, whatever the order.
void consider(const ValueMap& map, int index, const Chooser& chooser, Place& best) {
  const double bonus = index == chooser.before ? keep : 0;
  // P_reach is at most 1: most points need neither travel time nor value.
  if (map.most(index) + bonus < best.value) return;
  const ValueMap::Point& point = map.pass(index);
  if (point.value <= 0 || point.value + bonus < best.value) return;
  double reach = 1;
  if (chooser.kick_time < 9) {
    const kit::Robot& robot = *chooser.robot;
    const double own = skills::travel_time(point.position - robot.position, robot.velocity,
                                           skills::driving_limits(robot.specs));
    reach = reach_chance(own, chooser.kick_time + point.ball_time);
  }
  if (point.value * reach + bonus < best.value) return;
  if (map.at(index).value <= 0) return;
  const double value = point.value * reach + bonus;
  if (value < best.value || (value == best.value && index >= best.grid)) return;
  best = {index, point.position, value, point.ball_time};
}

}  // namespace

Place best_in_zone(const ValueMap& map, Zone zone, const Chooser& chooser) {
  Place best;
  // The place before is often still the best: with it first the others need no more than a glance.
  const int before = chooser.before;
  if (before >= 0 && Partition::zone_of_grid_point(before) == zone) consider(map, before, chooser, best);
  const int first = zone.column * grid_per_zone * grid_side + (zone.row + 1) * grid_per_zone;
  for (int i = 0; i < grid_per_zone; ++i) {
    for (int j = 0; j < grid_per_zone; ++j) consider(map, first + i * grid_side + j, chooser, best);
  }
  return best;
}

Place best_anywhere(const ValueMap& map, std::span<const Vector2d> taken, const Chooser& chooser) {
  Place best;
  const auto look_at = [&](int index) {
    const Vector2d position = map.position(index);
    const bool free = std::all_of(taken.begin(), taken.end(), [&position](const Vector2d& other) {
      return (other - position).squaredNorm() >= apart * apart;
    });
    if (free) consider(map, index, chooser, best);
  };
  if (chooser.before >= 0) look_at(chooser.before);
  for (int index = 0; index < grid_points; ++index) look_at(index);
  return best;
}

std::array<int, most_supports> assign_zones(const Partition& partition, const ZoneList& list,
                                            std::span<const kit::Robot* const> robots,
                                            std::span<const int> before) {
  const std::size_t count = std::min<std::size_t>(robots.size(), most_supports);
  std::array<std::array<double, most_supports>, most_supports> time{};
  for (std::size_t r = 0; r < count; ++r) {
    for (std::size_t z = 0; z < count; ++z) {
      const Vector2d to = partition.cell(list[z]).center() - robots[r]->position;
      time[r][z] = skills::travel_time(to, robots[r]->velocity, skills::driving_limits(robots[r]->specs));
      if (r < before.size() && before[r] == index_of(list[z])) time[r][z] -= settle;
    }
  }
  std::array<int, most_supports> order{}, best{};
  std::iota(order.begin(), order.end(), 0);
  double least = 1e9;
  do {
    double sum = 0;
    for (std::size_t r = 0; r < count; ++r) sum += time[r][static_cast<std::size_t>(order[r])];
    if (sum >= least) continue;
    least = sum;
    best = order;
  } while (std::next_permutation(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count)));
  return best;
}

}  // namespace reference

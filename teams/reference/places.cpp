#include "teams/reference/places.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>

#include "teams/skills/motion.h"

namespace reference {
namespace {

constexpr double keep = 0.03;   // of value, in favour of the place before
constexpr double apart = 1.0;   // [m] between greedy supporters (reference "football", 2.10)
constexpr double settle = 0.3;  // [s] in favour of the zone before

// The best of some grid points; of equals the one with the smallest index, whatever the order. Points are
// worked out in the order of the most they can be worth, so that few are.
class Search {
 public:
  Search(const ValueMap& map, const Chooser& chooser) : map_(map), chooser_(chooser) {}

  // P_reach is at most 1: most points need neither travel time nor value.
  bool may_be_best(int index) const { return most(index) >= best_.value; }
  void add(int index) {
    if (may_be_best(index)) waiting_[count_++] = {most(index), index};
  }
  void look_at(int index) {
    const double bonus = bonus_of(index);
    const ValueMap::Point& point = map_.pass(index);
    if (point.value <= 0 || point.value + bonus < best_.value) return;
    double reach = 1;
    if (chooser_.kick_time < 9) {
      const kit::Robot& robot = *chooser_.robot;
      const double own = skills::travel_time(point.position - robot.position, robot.velocity,
                                             skills::driving_limits(robot.specs));
      reach = reach_chance(own, chooser_.kick_time + point.ball_time);
    }
    if (point.value * reach + bonus < best_.value) return;
    if (map_.at(index).value <= 0) return;
    const double value = point.value * reach + bonus;
    if (value < best_.value || (value == best_.value && index >= best_.grid)) return;
    best_ = {index, point.position, value, point.ball_time};
  }
  const Place& best() {
    const auto begin = waiting_.begin();
    auto end = begin + static_cast<std::ptrdiff_t>(count_);
    std::make_heap(begin, end);
    for (; begin != end && begin->most >= best_.value; --end) {
      look_at(begin->index);
      std::pop_heap(begin, end);
    }
    return best_;
  }

 private:
  struct Waiting {
    double most;
    int index;
    bool operator<(const Waiting& other) const { return most < other.most; }
  };
  double bonus_of(int index) const { return index == chooser_.before ? keep : 0; }
  double most(int index) const { return map_.most(index) + bonus_of(index); }

  const ValueMap& map_;
  const Chooser& chooser_;
  std::array<Waiting, grid_points> waiting_;
  std::size_t count_ = 0;
  Place best_;
};

}  // namespace

Place best_in_zone(const ValueMap& map, Zone zone, const Chooser& chooser) {
  Search search(map, chooser);
  // The place before is often still the best: with it first the others need no more than a glance.
  const int before = chooser.before;
  if (before >= 0 && Partition::zone_of_grid_point(before) == zone) search.look_at(before);
  const int first = zone.column * grid_per_zone * grid_side + (zone.row + 1) * grid_per_zone;
  for (int i = 0; i < grid_per_zone; ++i) {
    for (int j = 0; j < grid_per_zone; ++j) search.add(first + i * grid_side + j);
  }
  return search.best();
}

Place best_anywhere(const ValueMap& map, std::span<const Vector2d> taken, const Chooser& chooser) {
  Search search(map, chooser);
  const auto is_free = [&](int index) {
    const Vector2d position = map.position(index);
    return std::all_of(taken.begin(), taken.end(), [&position](const Vector2d& other) {
      return (other - position).squaredNorm() >= apart * apart;
    });
  };
  if (chooser.before >= 0 && is_free(chooser.before)) search.look_at(chooser.before);
  for (int index = 0; index < grid_points; ++index) {
    if (search.may_be_best(index) && is_free(index)) search.add(index);
  }
  return search.best();
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

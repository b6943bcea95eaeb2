#include "sim/physics/placement.h"

#include <algorithm>
#include <limits>
#include <numbers>
#include <numeric>

#include "sim/physics/hull.h"

namespace physics {
namespace {

using world::Vector2d;

// Space left to what must not be touched [m]; ours: more than rounding, less than anyone sees.
constexpr double slack = 0.001;

constexpr double angle_step = 5 * std::numbers::pi / 180;
constexpr double radius_step = 0.02;
constexpr int radius_steps = 50;

Vector2d inside_walls(const world::Field& field, const Vector2d& position, double radius) {
  const Vector2d limit{field.half_length() + field.boundary_width - radius - slack,
                       field.half_width() + field.boundary_width - radius - slack};
  return position.cwiseMax(-limit).cwiseMin(limit);
}

// Distance of the centre from the spot, going in direction `away`, at which the hull is clear of the spot.
double clear_distance(const Placed& robot, const Vector2d& spot, const Vector2d& away, double clearance) {
  double distance = 0;
  // The hull's distance grows at most as fast as the centre's, so this climbs to the answer from below.
  for (int i = 0; i < 50; ++i) {
    const double missing =
        clearance - hull_distance(*robot.specs, spot + away * distance, robot.orientation, spot);
    if (missing < slack / 10) break;
    distance += missing;
  }
  return distance + slack;
}

bool is_free(const std::vector<Placed>& robots, const std::vector<bool>& counts, std::size_t self,
             std::span<const Fixture> fixtures, const world::Field& field, const Vector2d& position) {
  const double radius = robots[self].specs->radius;
  if (inside_walls(field, position, radius) != position) return false;
  for (const Fixture& fixture : fixtures) {
    if (fixture.min.z() < robots[self].specs->height && plane_distance(fixture, position) < radius + slack) {
      return false;
    }
  }
  for (std::size_t other = 0; other < robots.size(); ++other) {
    if (other == self || !counts[other]) continue;
    const double reach = radius + robots[other].specs->radius + slack;
    if ((robots[other].position - position).squaredNorm() < reach * reach) return false;
  }
  return true;
}

Vector2d nearest_free(const std::vector<Placed>& robots, const std::vector<bool>& counts, std::size_t self,
                      std::span<const Fixture> fixtures, const world::Field& field, const Vector2d& spot,
                      double clearance) {
  const Placed& robot = robots[self];
  Vector2d from_spot = robot.position - spot;
  // A robot right over the spot backs off, its flat front being the nearest side.
  if (from_spot.norm() < 1e-6) from_spot = -world::direction(robot.orientation);
  const Vector2d away = from_spot.normalized();

  const Vector2d straight = spot + away * clear_distance(robot, spot, away, clearance);
  if (is_free(robots, counts, self, fixtures, field, straight)) return straight;

  Vector2d best = inside_walls(field, straight, robot.specs->radius);
  double best_path = std::numeric_limits<double>::infinity();
  const int half_turn = 36;
  for (int k = -half_turn; k < half_turn; ++k) {
    const Vector2d direction = world::rotated(away, k * angle_step);
    const double least = clear_distance(robot, spot, direction, clearance);
    for (int i = 0; i <= radius_steps; ++i) {
      const Vector2d candidate = spot + direction * (least + i * radius_step);
      const double path = (candidate - robot.position).norm();
      if (path < best_path && is_free(robots, counts, self, fixtures, field, candidate)) {
        best = candidate;
        best_path = path;
      }
    }
  }
  return best;
}

}  // namespace

std::vector<bool> push_out(std::vector<Placed>& robots, std::span<const Fixture> fixtures,
                           const world::Field& field, const Vector2d& spot, double clearance) {
  std::vector<bool> moved(robots.size(), false);
  for (std::size_t i = 0; i < robots.size(); ++i) {
    moved[i] = hull_distance(*robots[i].specs, robots[i].position, robots[i].orientation, spot) <= clearance;
  }
  // Those that are still to be moved do not stand in each other's way; the farthest,
  // with the least to go, first.
  std::vector<bool> counts(robots.size());
  for (std::size_t i = 0; i < robots.size(); ++i) counts[i] = !moved[i];
  std::vector<std::size_t> order(robots.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return (robots[a].position - spot).squaredNorm() > (robots[b].position - spot).squaredNorm();
  });
  for (const std::size_t i : order) {
    if (!moved[i]) continue;
    robots[i].position = nearest_free(robots, counts, i, fixtures, field, spot, clearance);
    counts[i] = true;
  }
  return moved;
}

}  // namespace physics

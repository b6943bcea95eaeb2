#include "teams/skills/path.h"

#include <algorithm>
#include <cmath>

namespace skills {
namespace {

constexpr double keep_side = 0.2;  // [m]
// [m] More than any way round on the field: behind a goal there is no room beside the wall.
constexpr double no_way = 5;

// The first disc the segment cuts, or null. Discs we stand in are left by steering, not by the path.
const Disc* first_in_the_way(const Vector2d& from, const Vector2d& to, const Obstacles& obstacles) {
  const Vector2d way = to - from;
  const double length = way.norm();
  if (length < 1e-6) return nullptr;
  const Vector2d along = way / length;
  const Disc* first = nullptr;
  double nearest = length;
  for (const Disc& disc : obstacles.discs) {
    const Vector2d to_center = disc.center - from;
    const double forward = to_center.dot(along);
    if (forward <= 0) continue;
    const double beside = std::abs(along.x() * to_center.y() - along.y() * to_center.x());
    // Beside the way, or behind a nearer one (most are): no roots needed.
    if (beside >= disc.radius || forward - disc.radius >= nearest) continue;
    // A target inside a disc: come as near as it lets us.
    double radius = disc.radius;
    const double target_depth = (to - disc.center).norm();
    if (target_depth < radius) radius = target_depth - 0.01;
    if (beside >= radius || to_center.squaredNorm() <= radius * radius) continue;
    const double entry = forward - std::sqrt(radius * radius - beside * beside);
    if (entry < nearest) {
      nearest = entry;
      first = &disc;
    }
  }
  return first;
}

// A point just outside the disc: straight away from its centre, else the direction nearest to that where
// neither a wall nor another area is in the way.
Vector2d way_out(const Vector2d& from, const Disc& disc, const Obstacles& obstacles) {
  const Vector2d off = from - disc.center;
  const Vector2d away = off.norm() > 1e-6 ? Vector2d(off.normalized()) : Vector2d(1, 0);
  const auto is_free = [&](const Vector2d& place) {
    if (std::abs(place.x()) > obstacles.walls.x() || std::abs(place.y()) > obstacles.walls.y()) return false;
    for (const Disc& other : obstacles.discs) {
      if (&other != &disc && other.wide && (place - other.center).norm() < other.radius) return false;
    }
    return true;
  };
  constexpr double step = 0.15;  // [rad]
  for (int k = 0; k * step < 3.2; ++k) {
    for (const int side : {1, -1}) {
      const Vector2d exit = disc.center + world::rotated(away, side * k * step) * (disc.radius + 0.02);
      if (is_free(exit)) return exit;
    }
  }
  return disc.center + away * (disc.radius + 0.02);
}

Vector2d tangent_point(const Vector2d& from, const Disc& disc, int side) {
  const double radius = disc.radius + 0.02;  // [m] clear of the disc itself
  const Vector2d to_center = disc.center - from;
  const double distance = std::max(to_center.norm(), radius + 0.01);
  const double angle = std::asin(radius / distance);
  const double length = std::sqrt(distance * distance - radius * radius);
  return from + world::rotated(to_center.normalized(), side * angle) * length;
}

}  // namespace

Obstacles obstacles_for(const kit::View& view, const kit::Robot& robot, const Order& order) {
  Obstacles obstacles;
  const world::Field& field = view.field();
  const double own_radius = robot.specs.radius;
  const double run_off = field.boundary_width - own_radius - 0.02;  // not touching the wall
  obstacles.walls = {field.half_length() + run_off, field.half_width() + run_off};
  if (order.robot_margin >= 0) {
    const double speed = std::max(1.5, robot.velocity.norm());
    constexpr double longest = 0.4;  // [s] nobody drives straight on for longer
    const double far = longest * speed;
    for (const auto* robots : {&view.own, &view.opponents}) {
      for (const kit::Robot& other : *robots) {
        if (robots == &view.own && other.number == robot.number) continue;
        const double distance_square = (other.position - robot.position).squaredNorm();
        // Where it will be when we are there.
        const double time = distance_square >= far * far ? longest : std::sqrt(distance_square) / speed;
        const double margin = order.robot_margin + std::min(0.1 * time, 0.05);
        obstacles.add({other.position + other.velocity * time, own_radius + other.specs.radius + margin});
      }
    }
  }
  if (order.ball_distance >= 0 && view.ball.known) {
    obstacles.add({view.ball.position, own_radius + field.ball_radius + order.ball_distance, true, true});
  }
  const auto add_area = [&](double sign, double margin) {
    const world::DefenseArea& area = field.defense_area;
    const double x = sign * field.half_length();
    if (area.shape == world::DefenseArea::Shape::QuarterCircles) {
      // Two discs cover the area but for a lens of at most stretch^2 / (8 radius) = 3 cm,
      // taken into the margin.
      const double radius = area.radius + own_radius + margin;
      obstacles.add({{x, area.stretch / 2}, radius, true});
      obstacles.add({{x, -area.stretch / 2}, radius, true});
    } else {
      obstacles.add({{x, 0}, std::hypot(area.depth, area.width / 2) + own_radius + margin, true});
    }
  };
  if (!order.enter_own_area) add_area(-1, 0.02);
  add_area(1, order.their_area);
  return obstacles;
}

Path find_path(const Vector2d& from, const Vector2d& wanted, const Obstacles& obstacles, int side_before) {
  Vector2d to = wanted;
  for (const Disc& disc : obstacles.discs) {
    if (disc.strict && (to - disc.center).norm() < disc.radius) to = way_out(to, disc, obstacles);
  }
  // Out of an area first.
  for (const Disc& disc : obstacles.discs) {
    if (!disc.wide) continue;
    const Vector2d out = from - disc.center;
    const double depth = disc.radius - out.norm();
    if (depth < 0.01 || (to - disc.center).norm() < disc.radius - 0.01) continue;
    const Vector2d exit = way_out(from, disc, obstacles);
    return {exit, (exit - from).norm(), 0};
  }
  Path path{to, (to - from).norm(), 0};
  Vector2d goal = to;
  double behind_goal = 0;  // length of the way beyond `goal`
  for (int corner = 0; corner < 3; ++corner) {
    const Disc* disc = first_in_the_way(from, goal, obstacles);
    if (disc == nullptr) break;
    Path best;
    double best_cost = 0;
    for (const int side : {1, -1}) {
      const Vector2d via = tangent_point(from, *disc, side);
      const double length = (via - from).norm() + (goal - via).norm() + behind_goal;
      double cost = length;
      for (const Disc& other : obstacles.discs) {
        if (&other != disc && (via - other.center).norm() < other.radius) cost += 0.5;
      }
      if (std::abs(via.x()) > obstacles.walls.x() || std::abs(via.y()) > obstacles.walls.y()) {
        cost += no_way;
      }
      if (side_before != 0 && side != side_before && corner == 0) cost += keep_side;
      if (best.side != 0 && cost >= best_cost) continue;
      best_cost = cost;
      best = {via, length, side};
    }
    behind_goal = best.length - (best.via - from).norm();
    goal = best.via;
    const int side = corner == 0 ? best.side : path.side;
    path = {best.via, best.length, side};
  }
  return path;
}

}  // namespace skills

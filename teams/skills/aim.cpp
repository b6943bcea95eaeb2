#include "teams/skills/aim.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace skills {
namespace {

struct Edge {
  double angle;  // [rad] from the segment's first end
  int change;    // +1 a blocked interval begins, -1 it ends
};
constexpr std::size_t most_blockers = 24;
constexpr double most_covered = 0.25;  // [m] by an opponent while the ball flies (reference "football", 2.5)

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

// Without target and preference only the width is found.
Opening sweep(const Vector2d& from, const world::Segment& segment, std::span<const Blocker> blockers,
              std::optional<double> preferred, double bonus, bool with_target) {
  const Vector2d to_first = segment.from - from;
  const Vector2d to_second = segment.to - from;
  const double wide = cross(to_first, to_second);
  const double turn = wide < 0 ? -1.0 : 1.0;
  const double span = std::atan2(turn * wide, to_first.dot(to_second));
  const bool with_direction = with_target || preferred;
  const double first = with_direction ? world::angle_of(to_first) : 0;
  const Vector2d normal(segment.from.y() - segment.to.y(), segment.to.x() - segment.from.x());
  const double side = (from - segment.from).dot(normal);

  const Vector2d edge_first = to_first.normalized();
  const Vector2d edge_second = to_second.normalized();
  std::array<Edge, 2 * most_blockers> edges;
  std::size_t count = 0;
  for (const Blocker& blocker : blockers) {
    if (count + 2 > edges.size()) break;
    // Beyond the segment: cannot be in the way.
    if ((blocker.position - segment.from).dot(normal) * side < 0) continue;
    const Vector2d to = blocker.position - from;
    // Wholly outside the cone (most are): no angles needed.
    const double past_first = turn * cross(edge_first, to);
    const double past_second = -turn * cross(edge_second, to);
    if (past_first < -blocker.radius || past_second < -blocker.radius) continue;
    const double distance = to.norm();
    const double half = distance <= blocker.radius ? M_PI / 2 : std::asin(blocker.radius / distance);
    const double middle = std::atan2(past_first, edge_first.dot(to));
    const double begin = std::max(middle - half, 0.0);
    const double end = std::min(middle + half, span);
    if (begin >= end) continue;
    edges[count++] = {begin, 1};
    edges[count++] = {end, -1};
  }
  std::sort(edges.begin(), edges.begin() + static_cast<std::ptrdiff_t>(count),
            [](const Edge& a, const Edge& b) {
              return a.angle != b.angle ? a.angle < b.angle : a.change > b.change;
            });

  Opening best;
  double best_score = 0;
  const auto consider = [&](double begin, double end) {
    if (end <= begin) return;
    double score = end - begin;
    if (preferred) {
      const double aim = turn * world::wrap_angle(*preferred - first);
      if (aim >= begin && aim <= end) score += bonus;
    }
    if (score <= best_score) return;
    best_score = score;
    best.width = end - begin;
    if (with_direction) best.direction = world::wrap_angle(first + turn * 0.5 * (begin + end));
  };
  int depth = 0;
  double free_from = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (depth == 0 && edges[i].change > 0) consider(free_from, edges[i].angle);
    depth += edges[i].change;
    if (depth == 0) free_from = edges[i].angle;
  }
  consider(free_from, span);

  if (!with_target) return best;
  const world::Segment ray{from, from + world::direction(best.direction)};
  best.target = best.width > 0 ? world::line_intersection(ray, segment).value_or(segment.from)
                               : Vector2d(0.5 * (segment.from + segment.to));
  if (best.width <= 0) best.direction = world::angle_of(best.target - from);
  return best;
}

struct Blockers {
  std::array<Blocker, most_blockers> list;
  std::size_t count = 0;
  void add(const Vector2d& position, double radius) {
    if (count < list.size()) list[count++] = {position, radius};
  }
  std::span<const Blocker> span() const { return {list.data(), count}; }
};

world::Segment mouth(const world::Field& field) {
  const double post = field.goal_width / 2 - field.ball_radius;
  return {{field.half_length(), -post}, {field.half_length(), post}};
}

}  // namespace

Opening widest_opening(const Vector2d& from, const world::Segment& segment, std::span<const Blocker> blockers,
                       std::optional<double> preferred, double bonus) {
  return sweep(from, segment, blockers, preferred, bonus, true);
}

Vector2d goalie_later(const kit::View& view, const kit::Robot& goalie, const Vector2d& ball, double later) {
  const Vector2d goal = view.their_goal();
  const Vector2d out = ball - goal;
  const double far = out.norm();
  if (far < 1e-6) return goalie.position;
  const double before_goal = std::clamp((goalie.position - goal).norm(), 0.1, 0.6);
  const Vector2d wanted = goal + out * (std::min(before_goal, far) / far);
  const Vector2d way = wanted - goalie.position;
  const double length = way.norm();
  const double time = std::max(0.0, later - 0.12);
  // From rest to rest: d = t^2 / (2 (1 / a + 1 / b)).
  const double reached = time * time / (2 * (1 / goalie.specs.max_acceleration + 1 / goalie.specs.max_brake));
  return reached >= length ? wanted : Vector2d(goalie.position + way * (reached / length));
}

namespace {

// What is seen of a segment from a point: between two directions less than 180 degrees apart.
class Cone {
 public:
  Cone(const Vector2d& from, const world::Segment& segment)
      : from_(from), first_(segment.from - from), second_(segment.to - from) {
    if (cross(first_, second_) < 0) std::swap(first_, second_);
    first_length_ = first_.norm();
    second_length_ = second_.norm();
  }
  bool misses(const Vector2d& position, double radius) const {
    const Vector2d to = position - from_;
    return cross(first_, to) < -radius * first_length_ || cross(to, second_) < -radius * second_length_;
  }

 private:
  Vector2d from_, first_, second_;
  double first_length_, second_length_;
};

// Those that are in nobody's way are left out.
Blockers blockers_before_goal(const kit::View& view, const Vector2d& from, double kick_speed, int shooter,
                              double later) {
  const world::Field& field = view.field();
  const Cone cone(from, mouth(field));
  Blockers blockers;
  for (const kit::Robot& robot : view.opponents) {
    const Vector2d position = later > 0 && robot.number == view.game.their_keeper
                                  ? goalie_later(view, robot, from, later)
                                  : robot.position;
    if (position.x() < from.x() - 0.3) continue;  // behind the ball
    const double hull = robot.specs.radius + field.ball_radius;
    if (cone.misses(position, hull + most_covered)) continue;
    const double flight = (position - from).norm() / std::max(kick_speed, 1.0);
    const double free = std::max(0.0, flight - 0.12);
    const double covered = std::min(0.5 * robot.specs.max_acceleration * free * free, most_covered);
    blockers.add(position, hull + covered);
  }
  for (const kit::Robot& robot : view.own) {
    if (robot.number == shooter || robot.position.x() < from.x() - 0.3) continue;
    const double radius = robot.specs.radius + field.ball_radius + 0.02;
    if (!cone.misses(robot.position, radius)) blockers.add(robot.position, radius);
  }
  return blockers;
}

}  // namespace

Opening opening_to_goal(const kit::View& view, const Vector2d& from, double kick_speed, int shooter,
                        std::optional<double> preferred, double later) {
  const Blockers blockers = blockers_before_goal(view, from, kick_speed, shooter, later);
  return widest_opening(from, mouth(view.field()), blockers.span(), preferred);
}

double width_to_goal(const kit::View& view, const Vector2d& from, double kick_speed, int shooter,
                     double later) {
  const Blockers blockers = blockers_before_goal(view, from, kick_speed, shooter, later);
  return sweep(from, mouth(view.field()), blockers.span(), {}, 0, false).width;
}

double width_of_goal(const kit::View& view, const Vector2d& from) {
  const world::Segment goal = mouth(view.field());
  const Vector2d a = goal.from - from;
  const Vector2d b = goal.to - from;
  // The small number: openings are differences of angles, with rounding errors of their own.
  return std::atan2(std::abs(cross(a, b)), a.dot(b)) + 1e-9;
}

double kick_tolerance(double width) { return std::clamp(0.5 * width, 0.02, 0.1); }

double chance_to_pass(double width, double sigma) { return std::erf(width / (2 * std::sqrt(2.0) * sigma)); }

}  // namespace skills

#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "experiments/judge/true_event.h"
#include "experiments/judge/true_touches.h"
#include "sim/truth/truth.h"
#include "sim/world/field.h"
#include "sim/world/game_state.h"
#include "sim/world/rules/rule_set.h"

namespace judge {

/// One tick as the laws see it: the exact world, and what the acting referee had signalled when it began.
struct Moment {
  const truth::Frame& now;
  const truth::Frame& before;  ///< the tick before
  const world::GameState& state;
  bool entered = false;   ///< the location was entered since the tick before
  bool by_hand = false;   ///< the ball was put somewhere since the tick before
  bool ball_seen = true;  ///< by some camera
  const TrueTouches& touches;
  const world::RuleSet& rules;
  const Bands& bands;

  bool in(world::Location location) const { return state.location == location; }
  bool in_play() const { return in(world::Location::GameOn); }
  world::Vector2d ball() const { return now.ball.position.head<2>(); }
  /// How far the whole ball is outside the lines [m]; negative while any of it is above the field.
  double outside(const truth::Ball& ball) const {
    return world::distance_outside_lines(rules.field, ball.position.head<2>()) - rules.field.ball_radius;
  }
};

/// From a robot's hull, a disc with a flat front, to a point on the ground [m]; negative inside.
inline double hull_distance(const world::Field& field, const truth::Robot& robot,
                            const world::Vector2d& point) {
  constexpr double front = 0.073;  // [m] centre to the front plate
  const world::Vector2d local = world::rotated(point - robot.position, -robot.orientation);
  const double disc = local.norm() - field.robot_radius;
  const double corner = std::sqrt(field.robot_radius * field.robot_radius - front * front);
  if (local.x() * corner < front * std::abs(local.y())) return disc;  // the round part is nearest
  if (local.x() < front) return std::max(disc, local.x() - front);
  return std::hypot(local.x() - front, std::max(0.0, std::abs(local.y()) - corner));
}

/// From a robot's hull to the ball's surface [m], while the ball is not higher than a robot; else 1.
inline double gap(const world::Field& field, const truth::Robot& robot, const truth::Ball& ball) {
  constexpr double robot_height = 0.15;  // [m]
  if (ball.position.z() - field.ball_radius > robot_height) return 1;
  return hull_distance(field, robot, ball.position.head<2>()) - field.ball_radius;
}

/// Limits that both halves of the laws share: under STOP and GOAL robots keep away and slow.
inline bool is_stop(const world::GameState& state) {
  return state.location == world::Location::GameOff &&
         (state.command.kind == world::CommandKind::Stop || state.command.kind == world::CommandKind::Goal);
}

inline const truth::Robot* find_robot(const truth::Frame& frame, world::RobotId id) {
  const auto it = std::ranges::find(frame.robots, id, &truth::Robot::id);
  return it == frame.robots.end() ? nullptr : &*it;
}

inline std::size_t slot(world::RobotId id) {
  return (id.team == world::Team::Yellow ? 0U : world::max_robot_number + 1U) + id.number;
}
inline constexpr std::size_t robot_slots = 2 * (world::max_robot_number + 1);

/// Appends an event unless it was not even nearly one.
inline void report(std::vector<TrueEvent>& out, TrueEvent event) {
  if (event.margin > -near_bands) out.push_back(std::move(event));
}

}  // namespace judge

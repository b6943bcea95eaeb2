#include "autoref/detectors/area_touches.h"

#include <algorithm>
#include <chrono>

#include "autoref/detectors/ball.h"

namespace detectors {
namespace {

constexpr int frames_needed = 4;
constexpr int frames_pressed = 2;
constexpr double pressing = 0.01;  // [m] hull from the ball
constexpr double beside = 0.02;    // [m] hull from the ball: there the contact began
// ours: what is older is not remembered
constexpr world::Duration longest_ago = std::chrono::milliseconds{300};
constexpr double alone = 0.03;                 // [m] any opponent's hull from the ball
constexpr double alone_of_team_mates = 0.012;  // [m] the goalie stands near
constexpr world::Duration hidden_for = std::chrono::milliseconds{600};

}  // namespace

std::optional<world::Touch> AreaTouches::carried(const world::TrackedFrame& frame) {
  const world::TrackedRobot* carrier = nullptr;
  if (frame.ball && frame.ball->unseen < hidden_for) {
    const world::Vector2d ball = on_ground(*frame.ball);
    const auto far_from_area = [&](world::Side side) {
      return world::distance_to_defense_area(field_, side, ball) > 2 * field_.robot_radius;
    };
    if (!far_from_area(world::Side::Negative) || !far_from_area(world::Side::Positive)) {
      int carriers = 0;
      for (const world::TrackedRobot& robot : frame.robots) {
        if (!carries(field_, robot, *frame.ball)) continue;
        carrier = &robot;
        ++carriers;
      }
      const auto may_have_it = [&](const world::TrackedRobot& other) {
        const double enough = other.id.team == carrier->id.team ? alone_of_team_mates : alone;
        return other.id != carrier->id && gap_to_ball(field_, other, ball) < enough;
      };
      if (carriers != 1 || std::ranges::any_of(frame.robots, may_have_it)) carrier = nullptr;
    }
  }
  if (!carrier) {
    carried_ = 0;
    return std::nullopt;
  }
  carried_ = carrier->id == carrier_ ? carried_ + 1 : 1;
  carrier_ = carrier->id;
  if (carried_ < frames_needed) return std::nullopt;
  return world::Touch{carrier->id, frame.time, on_ground(*frame.ball)};
}

std::optional<world::Touch> AreaTouches::pressed(const world::TrackedFrame& frame,
                                                 const world::TrackedRobot& robot, world::Time earliest) {
  Near& near = near_[robot.id.team][robot.id.number];
  const double reach = field_.robot_radius + field_.ball_radius + beside;
  const auto in_area = [&](world::Side side) { return depth_in_area(field_, side, robot.position) > 0; };
  const bool on_the_ground = frame.ball && !frame.ball->flight;
  if (!on_the_ground || (on_ground(*frame.ball) - robot.position).squaredNorm() > reach * reach ||
      gap_to_ball(field_, robot, on_ground(*frame.ball)) > beside ||
      !(in_area(world::Side::Negative) || in_area(world::Side::Positive))) {
    near = {};
    return std::nullopt;
  }
  if (!near.since) near.since = frame.time;
  const world::Vector2d ball = on_ground(*frame.ball);
  const auto presses = [&](const world::TrackedRobot& one) {
    return gap_to_ball(field_, one, ball) < pressing;
  };
  const auto against = [&](const world::TrackedRobot& other) {
    return other.id != robot.id && presses(other) && (ball - robot.position).dot(ball - other.position) < 0;
  };
  const bool is_pressed = presses(robot) && std::ranges::any_of(frame.robots, against);
  near.pressed = is_pressed ? near.pressed + 1 : 0;
  if (near.pressed < frames_pressed) return std::nullopt;
  return world::Touch{robot.id, std::max({*near.since, frame.time - longest_ago, earliest}), ball};
}

const std::vector<AreaTouches::One>& AreaTouches::update(const world::TrackedFrame& frame,
                                                         const world::GameState& state) {
  past_.add(frame);
  found_.clear();
  const auto add = [&](const world::Touch& touch) {
    if (touch.probability < sure_ || !in_play(field_, state, touch)) return;
    if (const auto place = past_.position(touch.robot, touch.time)) found_.push_back({touch, *place});
  };
  for (const world::Touch& touch : frame.touches) add(touch);
  if (const auto touch = carried(frame)) add(*touch);
  for (const world::TrackedRobot& robot : frame.robots) {
    if (robot.id.number > world::max_robot_number) continue;
    const auto touch = pressed(frame, robot, state.location_time);
    if (touch && in_play(field_, state, *touch)) found_.push_back({*touch, robot.position});
  }
  return found_;
}

}  // namespace detectors

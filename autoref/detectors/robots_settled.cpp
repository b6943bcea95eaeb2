#include "autoref/detectors/robots_settled.h"

#include <chrono>

#include "autoref/detectors/ball.h"
#include "autoref/detectors/penalty.h"

namespace detectors {
namespace {

// A ball that nobody has seen for longer is not known to be in place (ours).
constexpr world::Duration unseen_limit = std::chrono::milliseconds{500};

std::size_t index(world::RobotId id) {
  return static_cast<std::size_t>(id.team) * (world::max_robot_number + 1) + id.number;
}

}  // namespace

void RobotsSettled::remember(const world::TrackedFrame& frame) {
  Place& now = past_[places_ % past_.size()];
  now = {};
  now.time = frame.time;
  if (frame.ball) now.ball = on_ground(*frame.ball);
  for (const world::TrackedRobot& robot : frame.robots) now.robot[index(robot.id)] = robot.position;
  ++places_;
}

bool RobotsSettled::steady(const world::TrackedFrame& frame, const world::GameState& state) const {
  // The oldest place of the ring is a window ago.
  const Place* then = places_ > window ? &past_[places_ % past_.size()] : nullptr;
  const auto moves = [&](const world::Vector2d& place, const std::optional<world::Vector2d>& before,
                         const world::Vector2d& velocity, double limit) {
    if (velocity.norm() <= limit) return false;
    return !before || (place - *before).norm() > limit * world::seconds(frame.time - then->time);
  };
  const std::optional<world::Vector2d> unknown;
  if (!frame.ball || frame.ball->unseen > unseen_limit) return false;
  const world::Vector2d ball_velocity = frame.ball->velocity.head<2>();
  if (moves(on_ground(*frame.ball), then ? then->ball : unknown, ball_velocity, ball_speed_)) return false;
  if (state.reset_position && (on_ground(*frame.ball) - *state.reset_position).norm() > tolerance_)
    return false;
  for (const world::TrackedRobot& robot : frame.robots) {
    const auto& before = then ? then->robot[index(robot.id)] : unknown;
    if (moves(robot.position, before, robot.velocity, robot_speed_)) return false;
  }
  return true;
}

bool RobotsSettled::in_position(const world::TrackedFrame& frame, const world::GameState& state) const {
  if (state.is_kickoff) return !robot_in_wrong_half(frame, state);
  if (state.restart != world::CommandKind::Penalty || state.call != world::CommandKind::Ready) return true;
  const PenaltyOffenders offenders = penalty_offenders(field_, penalty_line_, frame, state);
  return !offenders.attacker && !offenders.defender;
}

Events RobotsSettled::update(const world::TrackedFrame& frame, const world::GameState& state) {
  if (!entered_) entered_ = start_ = frame.time;
  remember(frame);
  const bool ready = in_position(frame, state);
  if (!ready || !steady(frame, state)) start_ = frame.time;

  const bool settled = frame.time - *start_ >= settled_for_;
  const bool too_long = frame.time - *entered_ >= (ready ? limit_ : 2 * limit_);
  if (!settled && !too_long) return {};
  entered_ = start_ = frame.time;
  return {{frame.time, world::RobotsSettled{!settled}}};
}

}  // namespace detectors

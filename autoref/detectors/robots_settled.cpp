#include "autoref/detectors/robots_settled.h"

#include <chrono>

#include "autoref/detectors/ball.h"
#include "autoref/detectors/penalty.h"

namespace detectors {
namespace {

// A ball that nobody has seen for longer is not known to be in place (ours).
constexpr world::Duration unseen_limit = std::chrono::milliseconds{500};

}  // namespace

bool RobotsSettled::steady(const world::TrackedFrame& frame, const world::GameState& state) const {
  if (!frame.ball || frame.ball->unseen > unseen_limit || frame.ball->velocity.norm() > ball_speed_)
    return false;
  if (state.reset_position && (on_ground(*frame.ball) - *state.reset_position).norm() > tolerance_)
    return false;
  for (const world::TrackedRobot& robot : frame.robots) {
    if (robot.velocity.norm() > robot_speed_) return false;
  }
  return true;
}

bool RobotsSettled::in_position(const world::TrackedFrame& frame, const world::GameState& state) const {
  if (state.is_kickoff) return !robot_in_wrong_half(frame, state);
  if (state.restart != world::CommandKind::Penalty || state.call != world::CommandKind::Ready) return true;
  const PenaltyOffenders offenders = penalty_offenders(field_, penalty_line_, frame, state);
  return !offenders.attacker && !offenders.defender;
}

std::vector<world::GameEvent> RobotsSettled::update(const world::TrackedFrame& frame,
                                                    const world::GameState& state) {
  if (!entered_) entered_ = start_ = frame.time;
  const bool ready = in_position(frame, state);
  if (!ready || !steady(frame, state)) start_ = frame.time;

  const bool settled = frame.time - *start_ >= settled_for_;
  const bool too_long = frame.time - *entered_ >= (ready ? limit_ : 2 * limit_);
  if (!settled && !too_long) return {};
  entered_ = start_ = frame.time;
  return {{frame.time, world::RobotsSettled{!settled}}};
}

}  // namespace detectors

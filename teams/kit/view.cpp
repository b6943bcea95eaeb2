#include "teams/kit/view.h"

#include <cmath>

#include "sim/world/geometry.h"

namespace kit {

const char* name(Phase phase) {
  switch (phase) {
    case Phase::Halt:
      return "halt";
    case Phase::Stop:
      return "stop";
    case Phase::Timeout:
      return "timeout";
    case Phase::PrepareKickoff:
      return "prepare kickoff";
    case Phase::Kickoff:
      return "kickoff";
    case Phase::PreparePenalty:
      return "prepare penalty";
    case Phase::Penalty:
      return "penalty";
    case Phase::DirectFree:
      return "direct";
    case Phase::IndirectFree:
      return "indirect";
    case Phase::Running:
      return "running";
  }
  return "unknown";
}

const Robot* find(const std::vector<Robot>& robots, int number) {
  for (const Robot& robot : robots) {
    if (robot.number == number) return &robot;
  }
  return nullptr;
}

bool holds_ball(const Robot& robot, const Ball& ball, double ball_radius) {
  if (robot.ball_contact) return true;
  const Vector2d offset = ball.position - robot.position;
  const double reach = robot.specs.center_to_dribbler + ball_radius + 0.015 + robot.specs.dribbler_width / 2;
  if (offset.squaredNorm() > reach * reach) return false;  // most are far away: no need to turn
  const Vector2d local = world::rotated(offset, -robot.orientation);
  // 15 mm: the noise of two positions and what the ball bounces in a dribbler (ours).
  const double gap = local.x() - robot.specs.center_to_dribbler - ball_radius;
  return gap < 0.015 && gap > -0.03 && std::abs(local.y()) < robot.specs.dribbler_width / 2 &&
         ball.height < 0.1;
}

}  // namespace kit

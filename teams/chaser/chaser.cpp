#include "teams/chaser/chaser.h"

#include <algorithm>

#include "teams/skills/ball_handling.h"

namespace chaser {
namespace {

using kit::Phase;

// May we touch the ball now?
bool may_play(const kit::Game& game) {
  const bool kick = game.phase == Phase::Kickoff || game.phase == Phase::DirectFree ||
                    game.phase == Phase::IndirectFree || game.phase == Phase::Penalty;
  return game.phase == Phase::Running || (kick && game.ours);
}

// The robot nearest to the ball; the one before has 0.3 m in its favour, so that two do not take turns.
int nearest_to_ball(const kit::View& view, int before) {
  int chosen = -1;
  double nearest = 1e9;
  for (const kit::Robot& robot : view.own) {
    if (view.game.forbidden == robot.number) continue;  // took the free kick, must not touch the ball again
    double distance = (robot.position - view.ball.position).norm();
    if (robot.number == before) distance -= 0.3;
    if (distance < nearest) {
      nearest = distance;
      chosen = robot.number;
    }
  }
  return chosen;
}

}  // namespace

void Chaser::play(const kit::View& view, world::TeamCommands& out) {
  chaser_ = nearest_to_ball(view, chaser_);
  const bool our_ball = may_play(view.game);
  const double share = 1.0 / (static_cast<double>(view.own.size()) + 1);
  int place = 0;
  for (const kit::Robot& robot : view.own) {
    ++place;
    skills::Order order;
    if (robot.number == chaser_ && our_ball) {
      // Behind the ball, then through it: 6 m/s at the middle of their goal, when the
      // aim is right to 0.1 rad.
      const double aim = world::angle_of(view.their_goal() - view.ball.position);
      order = skills::approach_and_kick(view, robot, aim, 6.0, 0, 0.1);
    } else {
      // A place of its own: one row across the own half, looking at the ball.
      order.target = {-0.25 * view.field().length, (place * share - 0.5) * view.field().width};
      order.heading = world::angle_of(view.ball.position - robot.position);
      // The rules: half a metre from a ball that is not ours, slowly while the game is stopped.
      order.ball_distance = our_ball ? 0.1 : 0.6;
      if (view.game.phase == Phase::Stop) order.max_speed = 1.4;
    }
    out.push_back(steering_.command(view, robot, order));
  }
}

}  // namespace chaser

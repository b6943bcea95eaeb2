#include "teams/kit/game_reader.h"

#include <algorithm>
#include <cmath>

#include "sim/world/geometry.h"

namespace kit {
namespace {

using world::CommandKind;

// [m] The ball is in play once it moved this far (laws of 2015, Law 9 decision 1).
constexpr double kick_travel = 0.05;
// Frames in a row: one noisy detection must not start the game for us (ours).
constexpr int kick_frames = 2;

Phase phase_after(CommandKind kind, Phase before) {
  switch (kind) {
    case CommandKind::Halt:
      return Phase::Halt;
    case CommandKind::Stop:
    case CommandKind::Goal:
      return Phase::Stop;
    case CommandKind::Timeout:
      return Phase::Timeout;
    case CommandKind::Direct:
      return Phase::DirectFree;
    case CommandKind::Indirect:
      return Phase::IndirectFree;
    case CommandKind::Kickoff:
      return Phase::PrepareKickoff;
    case CommandKind::Penalty:
      return Phase::PreparePenalty;
    case CommandKind::Start:
      return Phase::Running;
    case CommandKind::Ready:
      if (before == Phase::PrepareKickoff) return Phase::Kickoff;
      if (before == Phase::PreparePenalty) return Phase::Penalty;
      return Phase::Running;
  }
  return Phase::Halt;
}

bool waits_for_a_kick(Phase phase) {
  return phase == Phase::Kickoff || phase == Phase::Penalty || phase == Phase::DirectFree ||
         phase == Phase::IndirectFree;
}

}  // namespace

void GameReader::update(const world::RefereeMessage& message, const View& view, Game& game) {
  if (!counter_ || *counter_ != message.command_counter || !(*last_command_ == message.command)) {
    counter_ = message.command_counter;
    last_command_ = message.command;
    begin(message, view, game);
  }
  const double flip = defends_positive(message, team_) ? -1.0 : 1.0;
  const world::TeamInfo& us = message.teams[team_];
  const world::TeamInfo& them = message.teams[world::opponent(team_)];
  game.age = view.time - world::seconds(message.command_time);
  game.time_left.reset();
  if (message.action_time_left) game.time_left = world::seconds(*message.action_time_left);
  game.designated_position.reset();
  if (message.designated_position) game.designated_position = flip * *message.designated_position;
  game.own_score = us.score;
  game.their_score = them.score;
  game.own_keeper = us.keeper;
  game.their_keeper = them.keeper;
  game.max_robots = us.max_robots;

  if (waits_for_a_kick(game.phase)) {
    watch_the_kick(view, game);
  } else if (game.phase == Phase::Running && (game.forbidden || game.indirect)) {
    watch_for_another_touch(view, game);
  }
  ball_velocity_before_ = view.ball.velocity;
}

void GameReader::begin(const world::RefereeMessage& message, const View& view, Game& game) {
  game.phase = phase_after(message.command.kind, game.phase);
  if (world::has_team(message.command.kind)) game.ours = message.command.team == team_;
  if (game.phase == Phase::Running || game.phase == Phase::Stop || game.phase == Phase::Halt)
    game.ours = false;
  game.restart_position = view.ball.position;
  game.forbidden.reset();
  game.indirect = false;
  moved_frames_ = 0;
}

// The ball moved: it is in play, and whoever of us is nearest has kicked it.
void GameReader::watch_the_kick(const View& view, Game& game) {
  const bool moved = view.ball.known && (view.ball.position - game.restart_position).norm() > kick_travel;
  moved_frames_ = moved ? moved_frames_ + 1 : 0;
  if (moved_frames_ < kick_frames) return;
  if (game.ours) {
    game.indirect = game.phase == Phase::IndirectFree;
    double nearest = 1.0;  // [m] farther away nobody can have kicked it
    for (const Robot& robot : view.own) {
      const double gap = (robot.position - game.restart_position).norm();
      if (gap < nearest) {
        nearest = gap;
        game.forbidden = robot.number;
      }
    }
  }
  game.phase = Phase::Running;
  game.ours = false;
}

// A change of the ball's velocity beside another robot is its touch. Friction changes it by at most 0.05 m/s
// a tick (3 m/s^2 sliding), noise by about 0.1; 0.4 m/s is clear of both (ours). So is a break beam.
void GameReader::watch_for_another_touch(const View& view, Game& game) {
  const bool deflected = (view.ball.velocity - ball_velocity_before_).norm() > 0.4;
  for (const std::vector<Robot>* robots : {&view.own, &view.opponents}) {
    for (const Robot& robot : *robots) {
      if (robots == &view.own && game.forbidden == robot.number) continue;
      const double gap = (robot.position - view.ball.position).norm() - robot.specs.radius - ball_radius_;
      const bool touches = robot.ball_contact || (gap < 0.06 && deflected) ||
                           (gap < 0.01 && view.ball.velocity.norm() < 1.0 && view.ball.height < 0.1);
      if (!touches) continue;
      game.forbidden.reset();
      game.indirect = false;
      return;
    }
  }
}

}  // namespace kit

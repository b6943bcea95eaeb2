#include "teams/kit/game_reader.h"

#include <algorithm>
#include <cmath>

#include "sim/world/geometry.h"

namespace kit {
namespace {

using world::CommandKind;

// [m] The ball is in play once it moved this far (laws of 2015, Law 9 decision 1).
constexpr double kick_travel = 0.05;
// Frames in a row: one noisy detection must not start the game for us (ours). One more for their kick: who
// runs in too early is near the ball at the kick.
constexpr int our_kick_frames = 2;
constexpr int their_kick_frames = 3;
// The ball lies where it lay before, seen by a camera for this many frames: it was not kicked (ours).
constexpr int no_kick_frames = 4;
constexpr double no_kick_distance = 0.03;  // [m]
// [s] The referee may see a kick this much later than we do: 50 mm of travel and the vision's delay (ours).
constexpr double referee_delay = 0.4;

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

// In one of the last two frames: a ball that a filter only carries on does not prove a kick.
bool seen_now(const Ball& ball) { return ball.known && ball.unseen < 0.03; }

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

  told_to_wait_ = told_to_wait_ || game.time_left;
  if (waits_for_a_kick(game.phase)) {
    watch_the_kick(view, game);
  } else if (game.phase == Phase::Running && waits_for_a_kick(waited_in_)) {
    watch_for_no_kick(view, game);
  }
  if (game.phase == Phase::Running && (game.forbidden || game.indirect)) {
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
  still_frames_ = 0;
  waited_in_ = Phase::Halt;
  told_to_wait_ = false;
}

void GameReader::watch_the_kick(const View& view, Game& game) {
  const bool moved = seen_now(view.ball) && (view.ball.position - game.restart_position).norm() > kick_travel;
  moved_frames_ = moved ? moved_frames_ + 1 : 0;
  const bool referee_saw_it = told_to_wait_ && !game.time_left;
  if (referee_saw_it || moved_frames_ >= (game.ours ? our_kick_frames : their_kick_frames))
    in_play(view, game);
}

// The ball moved: it is in play, and whoever of us is nearest has kicked it.
void GameReader::in_play(const View& view, Game& game) {
  waited_in_ = game.phase;
  was_ours_ = game.ours;
  still_frames_ = 0;
  in_play_since_ = view.time;
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

void GameReader::watch_for_no_kick(const View& view, Game& game) {
  const bool still = seen_now(view.ball) && view.ball.velocity.norm() < 0.2 &&
                     (view.ball.position - game.restart_position).norm() < no_kick_distance;
  still_frames_ = still ? still_frames_ + 1 : 0;
  const bool referee_waits = game.time_left && view.time - in_play_since_ > referee_delay;
  if (told_to_wait_ ? !referee_waits : still_frames_ < no_kick_frames) return;
  game.phase = waited_in_;
  game.ours = was_ours_;
  game.forbidden.reset();
  game.indirect = false;
  moved_frames_ = 0;
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

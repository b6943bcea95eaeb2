#include "autoref/referee/overrule.h"

#include <fmt/format.h>

#include <chrono>

#include "autoref/automaton/interrupt.h"
#include "autoref/automaton/positions.h"
#include "autoref/automaton/restart.h"
#include "autoref/automaton/stages.h"
#include "autoref/referee/explain.h"

namespace referee {
namespace {

using enum world::CommandKind;
using world::Command;
using world::CommandKind;
using world::GameState;
using world::Location;
using world::Stage;
using world::Team;

constexpr int most_goals = 99;                                      // ours: beyond it is a slip of the hand
constexpr world::Duration longest_card = std::chrono::minutes{60};  // ours, likewise

Verdict refused(std::string why) { return {std::move(why), {}}; }
Verdict done(std::string deed) { return {{}, std::move(deed)}; }

std::string text_of(const Command& command) {
  std::string text = world::name(command.kind);
  if (world::has_team(command.kind)) text += std::string(" for ") + world::name(command.team);
  return text;
}

std::string restart_of(const GameState& state) {
  if (state.restart == Start) return "neutral start";
  return kick_name(state.restart) + " for " + world::name(state.kick_team);
}

bool is_kick(CommandKind kind) {
  return kind == Indirect || kind == Direct || kind == Kickoff || kind == Penalty;
}

// Play is stopped, by STOP unless it is stopped already.
void stop_play(Overruled& game) {
  GameState& state = game.automaton.state();
  if (state.location == Location::GameOff) return;
  state.halted = false;
  state.timeout_team.reset();
  game.automaton.send({Stop});
  game.automaton.enter(Location::GameOff);
}

void take_back(const Decision& decision, GameState& state) {
  const GameState& before = decision.before;
  const GameState& after = decision.after;
  for (const Team team : world::both_teams) {
    state.score[team] -= after.score[team] - before.score[team];
    state.red_cards[team] -= after.red_cards[team] - before.red_cards[team];
    state.shootout_kicks[team] -= after.shootout_kicks[team] - before.shootout_kicks[team];
    state.shootout_goals[team] -= after.shootout_goals[team] - before.shootout_goals[team];
    if (after.yellow_cards[team] > before.yellow_cards[team]) {
      --state.yellow_cards[team];
      if (!state.yellow_times[team].empty()) state.yellow_times[team].pop_back();  // it was the last one
    }
  }
}

Verdict act(const ReverseLastCall&, Overruled& game) {
  if (!game.decision) {
    return refused(game.any_decision
                       ? "there is no call to reverse: play has been restarted since the last one, or it was "
                         "reversed already; set the score or force a command instead"
                       : "there is no call to reverse: none has stopped play yet");
  }
  GameState& state = game.automaton.state();
  const Decision decision = *game.decision;
  game.decision.reset();
  take_back(decision, state);
  const std::string deed = "reverses the call \"" + decision.sentence + "\"";
  if (state.location == Location::Break && !state.halted && !state.timeout_team) return done(deed);

  const GameState& before = decision.before;
  if (before.location == Location::Setup) {
    automaton::next_restart(state, before.restart, before.kick_team,
                            before.reset_position.value_or(decision.ball));
  } else {
    state.kick_team = before.kick_team;
    automaton::next_neutral_start(game.automaton.rules(), state, decision.ball);
  }
  if (state.location != Location::Break) {
    game.automaton.send({Stop});
    game.automaton.enter(Location::GameOff);
  }
  return done(deed + ", so " + restart_of(state) + " from " + text(*state.reset_position));
}

Verdict act(const Pause&, Overruled& game) {
  const GameState& state = game.automaton.state();
  if (state.halted) return refused("the game is halted already");
  if (!automaton::can_halt(state)) {
    return refused(
        fmt::format("the game cannot be paused in {}, nothing is going on", world::name(state.location)));
  }
  automaton::halt(game.automaton, game.ball);
  return done("pauses the game");
}

Verdict act(const Resume&, Overruled& game) {
  GameState& state = game.automaton.state();
  if (!state.halted) return refused("there is nothing to resume: the game is not halted");
  automaton::resume(game.automaton);
  return done("resumes the game with a " + restart_of(state));
}

// Whether the game is between its beginning and its end, and in no half-time.
bool in_progress(const GameState& state) {
  return automaton::can_halt(state) || state.halted || state.timeout_team.has_value();
}

// The kick that is due, now: the rows are told that everybody is ready.
void send_due_kick(Overruled& game) {
  world::TrackedFrame now = game.frame;
  now.time = game.automaton.state().time;
  const automaton::Occurrence ready =
      automaton::occurrence_of({now.time, world::RobotsSettled{.waited_too_long = true}});
  game.automaton.take(now, {&ready, 1});
}

Verdict force_kick(const Command& command, Overruled& game) {
  GameState& state = game.automaton.state();
  const bool shootout = state.stage == Stage::Shootout;
  if (shootout && command.kind != Penalty) return refused("in a shoot-out there are penalty kicks only");
  if (command.kind != Kickoff && automaton::is_before_half(state.stage)) {
    return refused(fmt::format("{} begins with a kickoff; set the stage first", world::name(state.stage)));
  }
  if (state.location == Location::GameOff && Command{state.call, state.kick_team} == command) {
    send_due_kick(game);
    return done("sends " + text_of(command) + " at once");
  }
  const world::Vector2d place =
      state.location == Location::GameOn ? game.ball : state.reset_position.value_or(game.ball);
  stop_play(game);
  game.decision.reset();
  if (command.kind == Penalty) {
    automaton::next_penalty(game.automaton.rules(), state, command.team);
  } else if (command.kind == Kickoff) {
    automaton::next_restart(state, Kickoff, command.team, world::Vector2d::Zero());
  } else {
    automaton::next_restart(
        state, command.kind, command.team,
        automaton::free_kick_position(game.automaton.rules(), state, command.team, place));
  }
  return done(fmt::format("orders a {} from {}", restart_of(state), text(*state.reset_position)));
}

Verdict force_goal(Team scorer, Overruled& game) {
  GameState& state = game.automaton.state();
  if (!automaton::is_half(state.stage)) {
    return refused(
        fmt::format("no goal can be awarded in {}; set the score instead", world::name(state.stage)));
  }
  ++state.score[scorer];
  state.halted = false;
  state.timeout_team.reset();
  automaton::next_restart(state, Kickoff, world::opponent(scorer), world::Vector2d::Zero());
  game.automaton.send({Goal, scorer});
  game.automaton.enter(Location::GameOff);
  game.decision.reset();
  return done(fmt::format("awards a goal to {}, now yellow {} : {} blue", world::name(scorer),
                          state.score.yellow, state.score.blue));
}

Verdict force_timeout(Team team, Overruled& game) {
  GameState& state = game.automaton.state();
  if (state.location != Location::GameOff) {
    return refused("a time-out begins while play is stopped; send STOP first");
  }
  if (state.timeout_num[team] <= 0 || state.timeout_time[team].count() <= 0) {
    return refused(fmt::format("{} has no time-out left", world::name(team)));
  }
  state.timeout_team = team;
  --state.timeout_num[team];
  game.automaton.send({Timeout, team});
  game.automaton.enter(Location::Break);
  return done(fmt::format("gives {} a time-out", world::name(team)));
}

Verdict act(const ForceCommand& wish, Overruled& game) {
  const Command& command = wish.command;
  GameState& state = game.automaton.state();
  if (command.kind == Halt) return act(Pause{}, game);
  if (!in_progress(state)) {
    return refused(fmt::format("{} cannot be sent in {}; set the stage first", world::name(command.kind),
                               world::name(state.stage)));
  }
  if (command.kind == Stop) {
    automaton::interrupt(game.automaton, game.ball);
    state.halted = false;
    state.timeout_team.reset();
    game.automaton.send(command);
    game.automaton.enter(Location::GameOff);
    return done("stops play; next is a " + restart_of(state));
  }
  if (is_kick(command.kind)) return force_kick(command, game);
  if (command.kind == Goal) return force_goal(command.team, game);
  if (command.kind == Timeout) return force_timeout(command.team, game);
  if (command.kind == Ready) {
    if (state.location != Location::GameOff || state.call != Ready) {
      return refused("READY follows a kickoff or a penalty, and none has been announced");
    }
    send_due_kick(game);
    return done("sends READY at once");
  }
  // START
  if (state.location == Location::GameOn) return refused("play is on already");
  if (automaton::is_before_half(state.stage) || state.stage == Stage::Shootout) {
    return refused(fmt::format("{} has no neutral start", world::name(state.stage)));
  }
  stop_play(game);
  automaton::next_restart(state, Start, state.kick_team, game.ball);
  send_due_kick(game);
  game.decision.reset();
  return done("sends START, anyone may play the ball");
}

Verdict act(const SetScore& wish, Overruled& game) {
  for (const Team team : world::both_teams) {
    if (wish.score[team] < 0 || wish.score[team] > most_goals) {
      return refused(
          fmt::format("a score of {} is impossible; 0 to {} goals are", wish.score[team], most_goals));
    }
  }
  game.automaton.state().score = wish.score;
  return done(fmt::format("sets the score to yellow {} : {} blue", wish.score.yellow, wish.score.blue));
}

Verdict act(const SetCards& wish, Overruled& game) {
  const int robots = game.automaton.rules().robots_per_team;
  const int yellow = static_cast<int>(wish.yellow.size());
  if (wish.red < 0 || wish.red > robots || yellow > robots) {
    return refused(fmt::format("{} red and {} yellow cards are impossible; 0 to {} of each are", wish.red,
                               yellow, robots));
  }
  for (const world::Duration left : wish.yellow) {
    if (left.count() <= 0 || left > longest_card) {
      return refused(
          fmt::format("a yellow card with {:.0f} s left is impossible; more than 0 and at most {:.0f} s are",
                      world::seconds(left), world::seconds(longest_card)));
    }
  }
  GameState& state = game.automaton.state();
  const int more = yellow - static_cast<int>(state.yellow_times[wish.team].size());
  if (more > 0) state.yellow_cards[wish.team] += more;
  state.red_cards[wish.team] = wish.red;
  state.yellow_times[wish.team] = wish.yellow;
  return done(fmt::format("gives {} {} red and {} yellow cards", world::name(wish.team), wish.red, yellow));
}

Verdict act(const SetStage& wish, Overruled& game) {
  GameState& state = game.automaton.state();
  const world::RuleSet& rules = game.automaton.rules();
  const Stage stage = wish.stage;
  if (stage == state.stage) return refused(fmt::format("the stage is {} already", world::name(stage)));
  if ((automaton::ends_changed(stage) - automaton::ends_changed(state.stage)) % 2 != 0) {
    state.blue_on_positive_half = !state.blue_on_positive_half;
  }
  const bool runs_on = state.location == Location::GameOff && automaton::is_half(stage) &&
                       state.call != Penalty && state.stage != Stage::Shootout;
  state.stage = stage;
  state.stage_end.reset();
  if (const auto length = automaton::stage_length(rules, stage)) state.stage_end = state.time + *length;
  state.halted = false;
  state.timeout_team.reset();
  game.decision.reset();
  const std::string deed = fmt::format("sets the stage to {}", world::name(stage));
  if (automaton::is_half_time(stage) || stage == Stage::ShootoutBreak || stage == Stage::Post) {
    game.automaton.send({Halt});
    game.automaton.enter(Location::Break);
    return done(deed);
  }
  if (automaton::is_before_half(stage)) {
    automaton::next_restart(state, Kickoff, automaton::kickoff_team(state, stage), world::Vector2d::Zero());
  } else if (stage == Stage::Shootout) {
    const bool even = state.shootout_kicks.yellow == state.shootout_kicks.blue;
    automaton::next_penalty(rules, state, even ? state.first_kickoff : world::opponent(state.first_kickoff));
  } else if (!runs_on) {
    automaton::next_neutral_start(rules, state, game.ball);
  }
  game.automaton.send({Stop});
  game.automaton.enter(Location::GameOff);
  return done(deed + ", next is a " + restart_of(state));
}

Verdict act(const SetBallPosition& wish, Overruled& game) {
  GameState& state = game.automaton.state();
  const world::RuleSet& rules = game.automaton.rules();
  const double outside = world::distance_outside_lines(rules.field, wish.position);
  if (!wish.position.allFinite() || outside > 0) {
    return refused("the ball cannot be put at " + text(wish.position) + ", which is not on the field");
  }
  if (state.location == Location::GameOn) return refused("the ball is in play; send STOP first");
  if (!in_progress(state)) {
    return refused(fmt::format("in {} no restart is due for which the ball could be put anywhere",
                               world::name(state.stage)));
  }
  if (state.location == Location::Setup) {
    automaton::same_restart_again(state);
    stop_play(game);
  }
  state.reset_position = wish.position;
  return done(fmt::format("puts the ball at {} for the {}", text(wish.position), restart_of(state)));
}

}  // namespace

Verdict overrule(const Override& wish, Overruled& game) {
  if (wish.who.empty() || wish.why.empty()) return refused("an override must say who wants it and why");
  if ((wish.who + wish.why).find('\n') != std::string::npos)
    return refused("who and why must be one line each");
  if (game.automaton.state().location == Location::Init) return refused("the match has not begun");
  return std::visit([&](const auto& what) { return act(what, game); }, wish.what);
}

}  // namespace referee

#include "autoref/referee/explain_special.h"

#include <fmt/format.h>

#include "autoref/referee/explain.h"

namespace referee {
namespace {

using automaton::Transition;
using world::GameState;
using world::Stage;

std::string score_text(const world::PerTeam<int>& score) {
  return fmt::format("yellow {} : {} blue", score.yellow, score.blue);
}

std::string offence_text(const GameState& before) {
  const world::PenaltyKick& penalty = *before.penalty;
  const auto& offender = penalty.attacker ? penalty.attacker : penalty.defender;
  return text(*offender) + " was not where it must be at a penalty kick";
}

std::string again_text(const Transition& transition) {
  if (transition.occurrence.foul) return text(transition.occurrence.foul->by) + " committed a foul";
  const bool goal = transition.occurrence.event &&
                    std::holds_alternative<world::PossibleGoal>(transition.occurrence.event->what);
  return offence_text(transition.before) + (goal ? " and there was a goal" : " and there was no goal");
}

std::string shootout_text(const GameState& after) {
  return fmt::format("in the shoot-out yellow has {} of {} and blue {} of {}", after.shootout_goals.yellow,
                     after.shootout_kicks.yellow, after.shootout_goals.blue, after.shootout_kicks.blue);
}

std::string stage_end_text(const GameState& after) {
  switch (after.stage) {
    case Stage::HalfTime:
      return "the first half is over at " + score_text(after.score);
    case Stage::ExtraBreak:
      return "a draw after two halves, " + score_text(after.score) + ": extra time follows";
    case Stage::ExtraHalfTime:
      return "the first half of extra time is over at " + score_text(after.score);
    case Stage::ShootoutBreak:
      return "a draw after extra time, " + score_text(after.score) + ": a shoot-out follows";
    default:
      return "the game is over: " + score_text(after.score);
  }
}

std::string next_half_text(const GameState& after) {
  const char* half = after.stage == Stage::PreSecond       ? "the second half"
                     : after.stage == Stage::PreExtraFirst ? "extra time"
                                                           : "the second half of extra time";
  return fmt::format("{}, ends are changed: kickoff for {}", half, world::name(after.kick_team));
}

}  // namespace

std::optional<std::string> special_sentence(const Transition& transition, const world::RuleSet& rules) {
  const std::string_view row = transition.row->name;
  const GameState& after = transition.after;
  const char* kicker = world::name(transition.before.kick_team);
  if (row == "R15-15.b" || row == "R15-15.c") return again_text(transition);
  if (row == "R15-15.d") return "the penalty kick was no goal and time is up";
  if (row == "R8-10.a")
    return "the shoot-out begins, first with " + std::string(world::name(after.kick_team));
  if (row == "R8-10.b") return fmt::format("{} scored; {}", kicker, shootout_text(after));
  if (row == "R8-10.c" || row == "R8-10.d") return fmt::format("{} missed; {}", kicker, shootout_text(after));
  if (row == "R8-10.e") {
    return fmt::format("{} did not kick within {:.0f} s; {}", kicker, world::seconds(rules.kick_time),
                       shootout_text(after));
  }
  if (row == "R8-10.f") {
    const char* how = after.score.yellow == after.score.blue ? "over without a winner" : "decided";
    return fmt::format("the shoot-out is {}, {}; {}", how, score_text(after.score), shootout_text(after));
  }
  if (row == "T16.a") return stage_end_text(after);
  if (row == "T17.a") return next_half_text(after);
  if (row == "I-9.off" || row == "I-9.setup") {
    const world::RobotId by = transition.occurrence.foul->by;
    const auto& event = transition.occurrence.event;
    return event ? describe(*event) : text(by) + " committed an offence";
  }
  return std::nullopt;
}

std::string card_text(const Transition& transition) {
  for (const world::Team team : world::both_teams) {
    if (transition.after.red_cards[team] > transition.before.red_cards[team]) {
      return fmt::format(", red card for {}", world::name(team));
    }
    if (transition.after.yellow_cards[team] > transition.before.yellow_cards[team]) {
      return fmt::format(", yellow card for {}", world::name(team));
    }
  }
  return "";
}

}  // namespace referee

#include "autoref/automaton/stages.h"

#include <algorithm>

namespace automaton {

using enum world::Stage;
using world::Stage;
using world::Team;

bool is_half(Stage stage) {
  return stage == First || stage == Second || stage == ExtraFirst || stage == ExtraSecond;
}

bool is_before_half(Stage stage) {
  return stage == PreFirst || stage == PreSecond || stage == PreExtraFirst || stage == PreExtraSecond;
}

bool is_half_time(Stage stage) { return stage == HalfTime || stage == ExtraBreak || stage == ExtraHalfTime; }

Stage next_stage(const world::RuleSet& rules, Stage stage, bool draw) {
  switch (stage) {
    case PreFirst:
      return First;
    case First:
      return HalfTime;
    case HalfTime:
      return PreSecond;
    case PreSecond:
      return Second;
    case Second:
      return rules.winner && draw ? ExtraBreak : Post;
    case ExtraBreak:
      return PreExtraFirst;
    case PreExtraFirst:
      return ExtraFirst;
    case ExtraFirst:
      return ExtraHalfTime;
    case ExtraHalfTime:
      return PreExtraSecond;
    case PreExtraSecond:
      return ExtraSecond;
    case ExtraSecond:
      return rules.winner && draw ? ShootoutBreak : Post;
    case ShootoutBreak:
      return Shootout;
    case Shootout:
    case Post:
      return Post;
  }
  return Post;
}

std::optional<world::Duration> stage_length(const world::RuleSet& rules, Stage stage) {
  switch (stage) {
    case First:
    case Second:
      return rules.half_length;
    case ExtraFirst:
    case ExtraSecond:
      return rules.extra_half_length;
    case HalfTime:
      return rules.half_time;
    case ExtraBreak:
      return rules.extra_break;
    case ExtraHalfTime:
      return rules.extra_half_time;
    case ShootoutBreak:
      return rules.shootout_break;
    case PreFirst:
    case PreSecond:
    case PreExtraFirst:
    case PreExtraSecond:
    case Shootout:
    case Post:
      return std::nullopt;
  }
  return std::nullopt;
}

int ends_changed(Stage stage) {
  if (stage < PreSecond) return 0;
  if (stage < PreExtraFirst) return 1;
  return stage < PreExtraSecond ? 2 : 3;
}

Team kickoff_team(const world::GameState& state, Stage stage) {
  return ends_changed(stage) % 2 == 0 ? state.first_kickoff : world::opponent(state.first_kickoff);
}

world::Command stage_end_command(const world::GameState& state) {
  using enum world::CommandKind;
  if (is_half(state.stage) || state.stage == Shootout) return {Halt};
  if (!is_half_time(state.stage)) return {Stop};
  // The half that follows has changed ends once more.
  const Stage half = next_stage({}, state.stage, false);
  return {Kickoff, kickoff_team(state, half)};
}

bool shootout_is_decided(const world::RuleSet& rules, const world::GameState& state) {
  const auto& goals = state.shootout_goals;
  const auto& kicks = state.shootout_kicks;
  const auto can_reach = [&](Team team) {
    return goals[team] + std::max(0, rules.shootout_kicks - kicks[team]);
  };
  if (kicks.yellow >= rules.shootout_kicks && kicks.blue >= rules.shootout_kicks) {
    return kicks.yellow == kicks.blue && goals.yellow != goals.blue;
  }
  return goals.yellow > can_reach(Team::Blue) || goals.blue > can_reach(Team::Yellow);
}

bool shootout_is_over(const world::RuleSet& rules, const world::GameState& state) {
  const auto& kicks = state.shootout_kicks;
  return shootout_is_decided(rules, state) ||
         (kicks.yellow >= rules.shootout_limit && kicks.blue >= rules.shootout_limit);
}

}  // namespace automaton

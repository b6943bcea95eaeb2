#pragma once

#include <string>
#include <vector>

#include "experiments/report/summary.h"

namespace report {

inline Header example_header() {
  Header header;
  header.design = "night";
  header.description = "ours against theirs";
  header.rules = "ssl-2015";
  header.realism = "measured";
  header.seed = 7;
  header.pairs = 3;
  header.experiment = "0123456789abcdef0123456789abcdef";
  const record::TeamConfig a{.name = "ours", .command = {"team-a"}};
  record::TeamConfig b{.name = "theirs", .command = {"team-b"}};
  header.conditions.push_back({"equal", a, b, "measured"});
  b.robots = {0, 1, 2};
  b.speed_factor = 0.5;
  header.conditions.push_back({"hindered", a, b, "measured with radio.loss 0.2"});
  return header;
}

/// A finished game, goals from A's view.
inline record::Attempt game(const std::string& condition, int pair, int leg, int a_goals, int b_goals) {
  record::Attempt attempt;
  attempt.key = {condition, pair, leg};
  attempt.a_colour = leg == 0 ? world::Team::Blue : world::Team::Yellow;
  attempt.record.goals[attempt.a_colour] = a_goals;
  attempt.record.goals[world::opponent(attempt.a_colour)] = b_goals;
  attempt.record.fouls[attempt.a_colour] = 4;
  attempt.record.fouls[world::opponent(attempt.a_colour)] = 7;
  attempt.record.stoppages = 60;
  attempt.record.termination = record::Termination::Finished;
  attempt.record.at_fault = record::Party::Nobody;
  attempt.record.hash = record::game_id(attempt.key);
  return attempt;
}

/// The same, but A's program crashed.
inline record::Attempt forfeit_by_a(record::Attempt attempt) {
  attempt.record.termination = record::Termination::Crashed;
  attempt.record.at_fault = record::party(attempt.a_colour);
  return attempt;
}

inline record::Attempt spoilt(record::Attempt attempt) {
  attempt.record.termination = record::Termination::HarnessFault;
  attempt.record.at_fault = record::Party::Harness;
  return attempt;
}

/// Two conditions of three pairs, and a void game.
inline Summary example() {
  std::vector<record::Attempt> games;
  for (int pair = 0; pair < 3; ++pair) {
    for (int leg = 0; leg < 2; ++leg) {
      games.push_back(game("equal", pair, leg, pair, leg + 1));
      games.push_back(game("hindered", pair, leg, 3 + leg, pair));
    }
  }
  games.push_back(spoilt(games[0]));
  games.back().key.pair = 7;
  return summarise(example_header(), games);
}

/// The same game with match statistics: A shoots that often, B twice; A commits an offence.
inline record::Attempt with_statistics(record::Attempt attempt, int shots) {
  record::MatchStatistics statistics{.time = 1200, .in_play = 600, .passages = 60, .longest_passage = 30};
  record::TeamStatistics& a = statistics.teams[attempt.a_colour];
  record::TeamStatistics& b = statistics.teams[world::opponent(attempt.a_colour)];
  a = {.kicks = 40, .shots = shots, .shots_on_target = 2, .passes = 10, .passes_completed = 7};
  b = {.kicks = 30, .shots = 2, .shots_on_target = 1};
  a.possession = 200;
  b.possession = 100;
  attempt.record.statistics = statistics;
  attempt.record.fouls_by_kind[attempt.a_colour]["AimlessKick"] = 1;
  return attempt;
}

/// A ("equal") and B ("hindered") against the same opponent: A is 2, 3, 4 goals better in three pairs.
inline Summary panel_example() {
  Header header = example_header();
  header.conditions[0].panel = Header::Condition::Panel{"league", "the_rest", 'a'};
  header.conditions[1].panel = Header::Condition::Panel{"league", "the_rest", 'b'};
  std::vector<record::Attempt> games;
  for (int pair = 0; pair < 3; ++pair) {
    for (int leg = 0; leg < 2; ++leg) {
      games.push_back(with_statistics(game("equal", pair, leg, 3 + pair, 0), 5 + pair));
      games.push_back(game("hindered", pair, leg, 1, 0));
    }
  }
  return summarise(header, games);
}

/// B at 0.3, 0.6 and 0.9 of its speed: A wins by 4, 2 and 0 goals, each game a little different.
inline Summary sweep_example() {
  Header header = example_header();
  header.conditions.clear();
  std::vector<record::Attempt> games;
  for (int point = 0; point < 3; ++point) {
    Header::Condition condition;
    condition.name = "speed-0." + std::to_string(3 + 3 * point);
    condition.a = {.name = "ours", .command = {"team-a"}};
    condition.b = condition.a;
    condition.b.speed_factor = 0.3 + 0.3 * point;
    condition.realism = header.realism;
    condition.sweep = "speed";
    condition.values = {{"b.speed_factor", condition.b.speed_factor}};
    for (int pair = 0; pair < 3; ++pair) {
      for (int leg = 0; leg < 2; ++leg) {
        const int off = pair == 1 ? 0 : pair == 0 ? 1 : -1;
        games.push_back(with_statistics(game(condition.name, pair, leg, 4, 2 * point + off), 5 + pair));
      }
    }
    header.conditions.push_back(condition);
  }
  return summarise(header, games);
}

}  // namespace report

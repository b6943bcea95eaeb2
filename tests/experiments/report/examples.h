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

}  // namespace report

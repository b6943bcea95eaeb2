#pragma once

#include <string>

#include "experiments/record/attempt.h"
#include "experiments/schedule/design.h"
#include "experiments/schedule/schedule.h"

namespace stopping {

/// "new" against "old", one condition.
inline schedule::Design one_condition(int pairs, const schedule::Stopping& rule = {}) {
  schedule::Design design;
  design.name = "test";
  design.pairs = pairs;
  design.stopping = rule;
  const record::TeamConfig a{.name = "new", .command = {"a"}};
  const record::TeamConfig b{.name = "old", .command = {"b"}};
  design.conditions = {{"base", a, b}};
  return design;
}

/// Two conditions more, each of which could be a question of its own.
inline schedule::Design three_conditions(int pairs, const schedule::Stopping& rule = {}) {
  schedule::Design design = one_condition(pairs, rule);
  design.conditions.push_back(design.conditions[0]);
  design.conditions.push_back(design.conditions[0]);
  design.conditions[1].name = "second";
  design.conditions[2].name = "third";
  return design;
}

/// "new" and "old" each against "x" and "y".
inline schedule::Design panel(int pairs, const schedule::Stopping& rule = {}) {
  schedule::Design design = one_condition(pairs, rule);
  const schedule::Condition base = design.conditions.front();
  design.conditions.clear();
  for (const char* opponent : {"x", "y"}) {
    for (const char arm : {'a', 'b'}) {
      schedule::Condition condition = base;
      condition.name = std::string(1, arm) + "-vs-" + opponent;
      condition.a = arm == 'a' ? base.a : base.b;
      condition.b = {.name = opponent, .command = {opponent}};
      condition.panel = schedule::PanelPlace{"base", opponent, arm};
      design.conditions.push_back(condition);
    }
  }
  return design;
}

/// A game that was played to its end.
inline record::Attempt finished(const std::string& condition, int pair, int leg, int a_goals, int b_goals) {
  record::Attempt attempt;
  attempt.key = {condition, pair, leg};
  attempt.a_colour = leg == 0 ? world::Team::Blue : world::Team::Yellow;
  attempt.record.termination = record::Termination::Finished;
  attempt.record.at_fault = record::Party::Nobody;
  attempt.record.goals[attempt.a_colour] = a_goals;
  attempt.record.goals[world::opponent(attempt.a_colour)] = b_goals;
  return attempt;
}

/// A game that the harness spoilt.
inline record::Attempt spoilt(const std::string& condition, int pair, int leg, int number) {
  record::Attempt attempt;
  attempt.key = {condition, pair, leg};
  attempt.attempt = number;
  return attempt;
}

}  // namespace stopping

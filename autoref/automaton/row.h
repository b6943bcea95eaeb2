#pragma once

#include <optional>
#include <string_view>

#include "autoref/automaton/occurrence.h"
#include "sim/world/game_state.h"
#include "sim/world/rules/rule_set.h"
#include "sim/world/tracked_frame.h"

namespace automaton {

/// What a row's condition may look at.
struct Context {
  const world::GameState& state;
  const world::RuleSet& rules;
  const world::TrackedFrame& frame;
  const Occurrence* occurrence = nullptr;  ///< for rows that await one
};

/// One transition: a line of the paper's Tables 10 to 18.
struct Row {
  std::string_view name;  ///< "T11.7"; rows that the paper lacks are named after the note that explains them
  world::Location from{};
  world::Location to{};
  bool awaits_occurrence = false;
  /// The condition beside the location; null: always.
  bool (*holds)(const Context&) = nullptr;
  /// What is sent to the teams, from the state before the effect; null: nothing.
  world::Command (*command)(const Context&) = nullptr;
  /// The changes of variables. The context's state is the one being changed. Null: none.
  void (*effect)(const Context&, world::GameState&) = nullptr;
  /// A self-loop that counts as entering its location anew: the detectors there forget the past.
  bool enters_anew = false;
  std::string_view condition;  ///< in words, for the diagram
};

}  // namespace automaton

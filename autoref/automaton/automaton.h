#pragma once

#include <span>
#include <vector>

#include "autoref/automaton/event_loop.h"
#include "autoref/automaton/row.h"
#include "autoref/detectors/catalogue.h"

namespace automaton {

/// A row that was taken, with all that is needed to explain it.
struct Transition {
  const Row* row = nullptr;
  std::optional<world::Command> command;
  Occurrence occurrence;  ///< empty for rows that await none
  world::GameState before;
  world::GameState after;
};

/// The state a match begins with, before the first STOP.
struct Start {
  world::Team first_kickoff = world::Team::Yellow;
  bool blue_on_positive_half = true;
  world::PerTeam<int> keeper{};
};

/// The paper's hybrid automaton of a Small Size League game, with its detectors.
class Automaton {
 public:
  Automaton(const world::RuleSet& rules, const Start& start);

  /// One tick: the continuous variables run to the frame's time, each detector of the present location looks
  /// at the frame once, and the rows that hold are taken. The transitions are valid until the next call.
  ///
  /// @pre the frame is newer than the last one
  std::span<const Transition> update(const world::TrackedFrame& frame,
                                     std::span<const Request> requests = {});

  /// The same with occurrences given instead of detected, for tests of the tables.
  std::span<const Transition> take(const world::TrackedFrame& frame, std::span<const Occurrence> occurrences);

  /// The frames' clock starts anew at `time`, before the last frame (another log, another vision server): all
  /// instants are moved with it, and the detectors of the present location forget the past.
  void clock_restarted(world::Time time);

  /// What the detectors saw in the last update, taken by a row or not.
  std::span<const Occurrence> occurrences() const { return occurrences_; }

  // For what no row knows: the operator's overrides, and halts (interrupt.h). What is sent and entered so is
  // dated with the state's time.

  /// The continuous variables run to `time`.
  void run_clock_to(world::Time time);
  /// Transmits a command.
  void send(const world::Command& command);
  /// Enters a location, perhaps the present one anew; its detectors forget the past.
  void enter(world::Location location);

  void set_keeper(world::Team team, int number) { state_.keeper[team] = number; }

  const world::GameState& state() const { return state_; }
  /// For tests and overrides.
  world::GameState& state() { return state_; }
  const world::RuleSet& rules() const { return rules_; }
  /// How often the event loop had to be cut short.
  int loop_defects() const { return loop_defects_; }

 private:
  void run_rows(const world::TrackedFrame& frame, std::span<const Occurrence> occurrences);
  void take_row(const Row& row, const Context& context);

  world::RuleSet rules_;
  world::GameState state_;
  detectors::Detectors detectors_;
  EventLoop loop_;
  std::vector<Occurrence> occurrences_;
  std::vector<Transition> transitions_;
  int loop_defects_ = 0;
};

}  // namespace automaton

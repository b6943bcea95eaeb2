#include "autoref/automaton/automaton.h"

#include "autoref/automaton/clock.h"
#include "autoref/automaton/transitions.h"

namespace automaton {

Automaton::Automaton(const world::RuleSet& rules, const Start& start) : rules_(rules), detectors_(rules) {
  state_.first_kickoff = start.first_kickoff;
  state_.blue_on_positive_half = start.blue_on_positive_half;
  state_.keeper = start.keeper;
  state_.timeout_num = {rules.timeouts, rules.timeouts};
  state_.timeout_time = {rules.timeout_time, rules.timeout_time};
}

std::span<const Transition> Automaton::update(const world::TrackedFrame& frame,
                                              std::span<const Request> requests) {
  continuous_update(state_, frame.time);
  occurrences_.clear();
  for (const world::GameEvent& event : detectors_.update(frame, state_)) {
    occurrences_.push_back(occurrence_of(event));
  }
  for (const Request& request : requests) occurrences_.push_back({std::nullopt, std::nullopt, request});
  run_rows(frame, occurrences_);
  return transitions_;
}

std::span<const Transition> Automaton::take(const world::TrackedFrame& frame,
                                            std::span<const Occurrence> occurrences) {
  continuous_update(state_, frame.time);
  run_rows(frame, occurrences);
  return transitions_;
}

void Automaton::clock_restarted(world::Time time) {
  move_in_time(state_, time - state_.time);
  detectors_.enter(state_.location);
}

void Automaton::run_clock_to(world::Time time) { continuous_update(state_, time); }

void Automaton::send(const world::Command& command) {
  state_.command = command;
  ++state_.command_counter;
  state_.command_time = state_.time;
}

void Automaton::enter(world::Location location) {
  state_.location = location;
  state_.location_time = state_.time;
  detectors_.enter(location);
}

void Automaton::run_rows(const world::TrackedFrame& frame, std::span<const Occurrence> occurrences) {
  transitions_.clear();
  Context context{state_, rules_, frame};
  const auto holds = [&](const Row& row, const Occurrence* occurrence) {
    if (row.from != state_.location) return false;
    context.occurrence = occurrence;
    return !row.holds || row.holds(context);
  };
  const auto take = [&](const Row& row, const Occurrence* occurrence) {
    context.occurrence = occurrence;
    take_row(row, context);
  };
  const auto result = loop_.run(automaton::transitions(), occurrences, holds, take);
  if (result.cut_short) ++loop_defects_;
}

void Automaton::take_row(const Row& row, const Context& context) {
  Transition transition;
  transition.row = &row;
  if (context.occurrence) transition.occurrence = *context.occurrence;
  transition.before = state_;

  if (row.command) transition.command = row.command(context);
  if (row.effect) row.effect(context, state_);
  if (transition.command) send(*transition.command);
  if (row.from != row.to || row.enters_anew) enter(row.to);
  transition.after = state_;
  transitions_.push_back(std::move(transition));
}

}  // namespace automaton

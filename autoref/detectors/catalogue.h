#pragma once

#include <initializer_list>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "autoref/detectors/detector.h"
#include "sim/world/rules/rule_set.h"

namespace detectors {

/// Some of the automaton's locations.
class Locations {
 public:
  constexpr Locations(std::initializer_list<world::Location> locations) {
    for (const world::Location location : locations) bits_ |= bit(location);
  }
  constexpr bool contains(world::Location location) const { return (bits_ & bit(location)) != 0; }

 private:
  static constexpr unsigned bit(world::Location location) { return 1u << static_cast<unsigned>(location); }
  unsigned bits_ = 0;
};

/// One line of the catalogue: which detector runs where.
struct Entry {
  std::string_view name;
  Locations where;
  std::unique_ptr<Detector> (*make)(const world::RuleSet& rules);
};

/// The rulebook's table of game events: every detector with its applicability.
std::span<const Entry> catalogue();

/// One detector of every kind that the rule set names, run as the catalogue says.
class Detectors {
 public:
  /// @throws std::invalid_argument for a name that is not in the catalogue
  explicit Detectors(const world::RuleSet& rules);

  /// To be called when the automaton enters a location, also anew: those that run there forget the past.
  void enter(world::Location location);

  /// Runs those of the state's location, each exactly once. The events are in catalogue order and valid until
  /// the next call.
  std::span<const world::GameEvent> update(const world::TrackedFrame& frame, const world::GameState& state);

 private:
  struct Running {
    Locations where;
    std::unique_ptr<Detector> detector;
  };

  std::vector<Running> running_;  // in the order of the catalogue
  std::vector<world::GameEvent> events_;
};

}  // namespace detectors

#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "experiments/judge/game.h"
#include "experiments/judge/tables.h"

namespace judge {

// What the tables count, and how they write it.

using Cases = std::vector<const Case*>;

Cases cases_of(std::span<const GameResult> games, const std::string& shadow,
               const std::function<bool(const Case&)>& wanted);
/// Names, the acting referee's first.
std::vector<std::string> shadows_of(std::span<const GameResult> games);

/// "132/158 = 0.835 [0.770, 0.885]", with Wilson's 95 % interval; "none" of none.
std::string share(std::int64_t good, std::int64_t n);
std::string whole(std::int64_t number);
/// "too few clear exits", or nothing when there are enough.
std::string too_few(std::int64_t there, int wanted, const std::string& what);
/// Median and 95 % of the delay from what happened to its report [ms], of clear events that were found.
std::string delays(const Cases& cases);

inline bool is_exit(const Case& one) { return one.event == Event::Exit; }
/// It happened, beyond its band, and one team alone touched the ball last.
inline bool clear_exit(const Case& one) {
  return is_exit(one) && one.result != Result::Extra && !one.close() && !one.ambiguous();
}

/// The classes of the paper's Figure 9.
struct ExitClasses {
  int clear = 0, correct = 0, wrong = 0, missed = 0, extra = 0, chip = 0, ambiguous = 0, ambiguous_missed = 0,
      close = 0, within_tenth = 0;
  explicit ExitClasses(const Cases& cases);

  int all() const { return clear + ambiguous; }
  /// That there was an exit is certain, whoever touched last.
  int all_missed() const { return missed + ambiguous_missed; }
  /// Calls without an exit, for each thousand clear exits.
  double extra_in_1000() const { return clear > 0 ? 1000.0 * (extra + chip) / clear : 0; }
};

/// What became of the true and the called ones of another event.
struct EventClasses {
  int found = 0, late = 0, missed = 0, extra = 0, close = 0, close_called = 0, ambiguous = 0, near_misses = 0,
      named = 0, right_robot = 0, within_tenth = 0;
  EventClasses(std::span<const GameResult> games, const std::string& shadow, Event event);

  int happened() const { return found + late + missed; }
  int called() const { return found + extra; }  // late ones are neither right nor nothing
};

/// Goals and chip goals, beyond their band.
struct GoalClasses {
  int goals = 0, found = 0, missed = 0, extra = 0, chip_extra = 0, close = 0, chips = 0, chips_found = 0,
      chips_extra = 0;
  std::string delay;
  GoalClasses(std::span<const GameResult> games, const std::string& shadow);
};

/// Whether that shadow looks by other rules or is another program: then every event is
/// compared, not exits alone.
bool is_other_referee(const std::string& shadow);
/// Whether it can call that event at all.
bool may_call(const std::string& shadow, Event event);

/// What each witness said at each clear exit that the acting referee's detectors called.
struct Sayings {
  std::vector<std::string> witnesses;
  Cases exits;

  bool right(std::size_t witness, const Case& exit) const;
  /// Exits that one was right about and the other was not, and the reverse.
  std::pair<int, int> against(std::size_t a, std::size_t b) const;
  /// Place of that witness; nothing: there is none.
  std::optional<std::size_t> witness(const std::string& name) const;
};
/// Mean square of the difference between the probabilities that were said and what was; "" of none.
std::string brier(const std::vector<std::pair<double, bool>>& said);
Sayings sayings_of(std::span<const GameResult> games);

}  // namespace judge

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
};

/// What each witness said at each clear exit that the acting referee's detectors called.
struct Sayings {
  std::vector<std::string> witnesses;
  Cases exits;

  bool right(std::size_t witness, const Case& exit) const;
};
Sayings sayings_of(std::span<const GameResult> games);

}  // namespace judge

#pragma once

#include <optional>
#include <string>

#include "experiments/schedule/design.h"

namespace commands {

/// How long a game takes here, and how that is known.
struct Speed {
  double game_seconds = 0;  ///< [s] wall, of a whole game on one processor
  std::string source;       ///< "measured in ...", for the reader
};

/// How much games of these teams differ from each other, as earlier games show.
struct Spread {
  double goal_deviation = 0;  ///< standard deviation of one game's goal difference
  double correlation = 0;     ///< of the two games of a pair
  double draws = 0;           ///< share of all games
  std::int64_t games = 0;     ///< it was seen in
};

/// What `matchday plan` says: size, time, power, and the course of a sequential test.
std::string plan_text(const schedule::Design& design, const std::optional<Speed>& speed,
                      const std::optional<Spread>& spread, int workers);

}  // namespace commands

#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <iosfwd>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "experiments/record/attempt.h"
#include "experiments/runner/time_left.h"
#include "experiments/schedule/design.h"

namespace runner {

/// What a run says while it goes on: one line that is drawn over on a terminal, a line per game otherwise.
class Progress {
 public:
  using Clock = std::chrono::steady_clock;

  /// @param resolved  games that were there already
  Progress(std::ostream& out, bool terminal, const schedule::Design& design, std::size_t total,
           std::size_t resolved);

  /// Takes in games that were there already, or the one that has just ended.
  void known(const record::Attempt& attempt);
  void ended(const record::Attempt& attempt, std::size_t resolved, Clock::time_point now = Clock::now());
  /// How long the rest will take, until it is told anew.
  void left(const std::optional<TimeLeft::Estimate>& estimate) { left_ = estimate; }

  /// There are fewer games to be played than it seemed.
  void set_total(std::size_t total, std::size_t resolved) {
    total_ = total;
    resolved_ = resolved;
    resolved_before_ = std::min(resolved_before_, resolved);
  }

  /// Pairs of a condition from this number on do not count: its stopping rule has ended it.
  void stop(const std::string& condition, int next_pair);

  /// Draws the line anew, at most a few times a second.
  void tick(std::size_t running, Clock::time_point now = Clock::now());
  /// Removes the line.
  void clear();
  /// A sentence of its own.
  void say(const std::string& sentence);

  /// "5/24 games, 4.2/min, 4:31 left (4:02-5:00) | equal 2-1-1, half-speed 0-0-0"
  ///
  /// Wins, draws and losses of team A are those of the report: of pairs whose two games count.
  std::string line(Clock::time_point now) const;

 private:
  struct Score {
    int wins = 0;  ///< of team A
    int draws = 0;
    int losses = 0;
  };
  struct Games {
    std::string condition;
    std::map<int, std::vector<record::Attempt>> begun;  ///< by pair: those whose games do not count yet
    std::map<int, Score> pairs;                         ///< that count
    std::optional<int> next_pair{};                     ///< pairs from this number on do not count
    Score score() const;
  };

  std::ostream& out_;
  bool terminal_;
  const schedule::Design& design_;
  std::size_t total_;
  std::size_t resolved_;
  std::size_t resolved_before_;
  std::vector<Games> conditions_;
  std::optional<TimeLeft::Estimate> left_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point drawn_{};
};

}  // namespace runner

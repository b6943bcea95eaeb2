#pragma once

#include <array>
#include <cstddef>
#include <deque>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "experiments/record/attempt.h"
#include "experiments/schedule/schedule.h"

namespace runner {

/// One attempt that is to be made at one game.
struct Job {
  schedule::Game game;
  int attempt = 1;
};

/// The attempt a job leads to, before anything is known of how it went.
record::Attempt attempt_of(const Job& job);

/// What of a schedule is still to be played, given what the ledger holds.
///
/// First every game once, in the schedule's order; pairs that had a void game follow at the end, both legs
/// anew, so that a fault that passes by itself does not use up the attempts of one pair.
class Plan {
 public:
  /// @throws record::StorageError when an attempt belongs to no game of the design
  Plan(const schedule::Design& design, std::span<const record::Attempt> attempts);

  /// The next attempt to make; nothing when there is none at the moment.
  std::optional<Job> next();

  bool idle() const { return waiting_.empty(); }  ///< there is none at the moment

  /// An attempt that could not be begun is the next again.
  void put_back(const record::GameKey& key, int attempt);

  /// Takes in how an attempt ended.
  void add(const record::Attempt& attempt);

  /// Pairs of a condition from this number on are not needed any more; what was played of them already is
  /// not counted either.
  void stop(const std::string& condition, int next_pair);

  std::size_t total() const;
  /// Games that need not be played again: they count, or their pair was given up.
  std::size_t resolved() const;
  std::size_t given_up_pairs() const;

 private:
  struct Pair {
    int attempt = 1;
    std::array<bool, 2> played{};  ///< in that attempt
    bool needed = true;
    bool given_up() const { return attempt > record::max_attempts; }
  };
  struct Entry {
    std::size_t index;  ///< in the schedule
    int attempt;
  };

  std::size_t pair_index(const record::GameKey& key) const;
  void start_again(std::size_t pair, int attempt);

  schedule::Design design_;
  std::vector<Pair> pairs_;  ///< in the schedule's order
  std::deque<Entry> waiting_;
};

}  // namespace runner

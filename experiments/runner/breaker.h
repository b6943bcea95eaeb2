#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "experiments/record/attempt.h"
#include "experiments/schedule/limits.h"

namespace runner {

/// Notices that a night has become useless: too many void games, or one team that never gets to play.
///
/// It looks at the games of this run only, so that continuing after a repair begins anew.
class Breaker {
 public:
  // Ours.
  static constexpr int least_attempts = 20;     ///< before a share means anything
  static constexpr int forfeits_in_a_row = 30;  ///< of one team: it does not run here

  Breaker(const schedule::Limits& limits, std::size_t games);

  void add(const record::Attempt& attempt);

  /// Why the run has to stop; nothing while all is well.
  const std::optional<std::string>& tripped() const { return reason_; }

  /// "in 5 of 6 void games the host waited for team A"; empty when it waited for none thrice: chance. A team that
  /// is losing could arrange that the machine seems too slow.
  std::string waits() const;

 private:
  schedule::Limits limits_;
  int most_voids_;  ///< the retry budget
  int attempts_ = 0;
  int voids_ = 0;
  int voids_in_a_row_ = 0;
  int waited_for_a_ = 0;  ///< in void games
  int waited_for_b_ = 0;
  int forfeits_a_ = 0;  ///< in a row, by team A
  int forfeits_b_ = 0;
  std::optional<std::string> reason_;
};

}  // namespace runner

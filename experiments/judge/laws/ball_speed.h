#pragma once

#include <optional>
#include <vector>

#include "experiments/judge/laws/moment.h"

namespace judge {

/// A robot made the ball faster than it may be (Law 12): the greatest speed between two touches, in space.
///
/// Margin  the speed beyond the limit, less in proportion for a ball that the next robot stopped within
///         0.2 s. In both cases a band is 40 mm, by which the ball went farther than at the limit.
class BallSpeed {
 public:
  void watch(const Moment& moment, std::vector<TrueEvent>& out);
  /// The game is over.
  void finish(const world::RuleSet& rules, const Bands& bands, std::vector<TrueEvent>& out);

 private:
  void finish(const Moment& moment, std::vector<TrueEvent>& out);
  static void tell(TrueEvent fastest, double flight, const world::RuleSet& rules, const Bands& bands,
                   std::vector<TrueEvent>& out);

  std::optional<std::size_t> touch_;  // that began this flight
  TrueEvent fastest_;
  bool in_play_ = false;  // at any time of it
};

}  // namespace judge

#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "experiments/judge/laws/moment.h"

namespace judge {

/// The ball is stuck (Law 5): in no second of the last twelve did it get 0.25 m away from where it was.
///
/// Margin  by how much the best of those seconds fell short.
/// Near    the longest stretch without progress was less than two bands of distance better, or ended less
///         than two bands of time before it was too long.
class Progress {
 public:
  /// @param goalie_holds  that is no lack of progress, but an offence of its own
  /// @param ball_is_out   nobody has said so: where it goes then is no progress, and that is told at any time
  void watch(const Moment& moment, bool goalie_holds, bool ball_is_out, std::vector<TrueEvent>& out);

 private:
  /// No second was better than `limit`.
  struct Stretch {
    std::optional<world::Time> since{};
    double best = 0;  // [m]
  };
  std::deque<std::pair<world::Time, world::Vector2d>> places_;  // of the last second
  Stretch nominal_, near_;
  std::optional<std::size_t> out_;  // index of what was told of a ball that is out
};

}  // namespace judge

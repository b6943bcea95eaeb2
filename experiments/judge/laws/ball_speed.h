#pragma once

#include <optional>
#include <vector>

#include "experiments/judge/laws/moment.h"

namespace judge {

/// A robot made the ball faster than it may be (Law 12): the greatest speed between two touches, in space.
///
/// Margin  the speed beyond the limit.
class BallSpeed {
 public:
  void watch(const Moment& moment, std::vector<TrueEvent>& out);

 private:
  void finish(const Moment& moment, std::vector<TrueEvent>& out);

  std::optional<std::size_t> touch_;  // that began this flight
  TrueEvent fastest_;
  bool in_play_ = false;  // at any time of it
};

}  // namespace judge

#pragma once

#include <array>
#include <deque>
#include <optional>
#include <vector>

#include "experiments/judge/laws/moment.h"

namespace judge {

/// Ball in its place, robots slow for long enough, or the wait was too long (paper, Algorithm 3).
///
/// A speed is the distance covered in a tenth of a second, since robots that lean on each other tremble.
/// The same is watched with limits a little wider and a little narrower; where these two do not agree within
/// 0.3 s the moment is nobody's fault: margin 0.5.
class Settling {
 public:
  void watch(const Moment& moment, std::vector<TrueEvent>& out);

 private:
  struct Wait {
    world::Time begin{}, steady{};
    std::optional<world::Time> settled{};
  };
  void measure(const Moment& moment);
  bool steady(const Moment& moment, int wider) const;
  bool ready(const Moment& moment, int wider) const;
  void finish(std::vector<TrueEvent>& out);

  bool waiting_ = false;
  std::uint32_t counter_ = 0;  // of the command
  std::optional<world::Time> left_;
  std::deque<truth::Frame> past_;  // of a tenth of a second
  double ball_speed_ = 0;          // [m/s]
  double robot_speed_ = 0;         // [m/s] of the fastest
  std::array<Wait, 3> waits_;      // narrower, as they are, wider
};

}  // namespace judge

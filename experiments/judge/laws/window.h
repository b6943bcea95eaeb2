#pragma once

#include <algorithm>
#include <deque>
#include <utility>

#include "sim/world/time.h"

namespace judge {

/// The least and greatest of what was added in the last `length`; nothing is known before that much
/// time has been covered.
class Window {
 public:
  explicit Window(world::Duration length = {}) : length_(length) {}

  void clear() { samples_.clear(); }
  void add(world::Time time, double value) {
    samples_.emplace_back(time, value);
    while (samples_.size() > 2 && samples_[1].first + length_ <= time) samples_.pop_front();
  }
  bool full() const { return !samples_.empty() && samples_.back().first - samples_.front().first >= length_; }
  double least() const { return std::ranges::min_element(samples_, {}, second)->second; }
  double greatest() const { return std::ranges::max_element(samples_, {}, second)->second; }

 private:
  static double second(const std::pair<world::Time, double>& sample) { return sample.second; }

  world::Duration length_;
  std::deque<std::pair<world::Time, double>> samples_;
};

}  // namespace judge

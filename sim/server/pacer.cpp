#include "sim/server/pacer.h"

#include <algorithm>

namespace server {

Pacer::Pacer(Clock::time_point now, world::Time simulated, double speed)
    : origin_(now), simulated_origin_(simulated), speed_(speed) {}

Pacer::Clock::time_point Pacer::due(world::Time simulated) const {
  if (speed_ == 0) return Clock::time_point::max();
  const std::chrono::duration<double, std::nano> wait = (simulated - simulated_origin_) / speed_;
  return origin_ + std::chrono::duration_cast<Clock::duration>(wait);
}

world::Time Pacer::simulated(Clock::time_point now) const {
  const std::chrono::duration<double, std::nano> passed = (now - origin_) * speed_;
  return simulated_origin_ + std::chrono::duration_cast<world::Duration>(passed);
}

void Pacer::set_speed(Clock::time_point now, world::Time next, double speed) {
  simulated_origin_ = std::min(simulated(now), next);
  origin_ = now;
  speed_ = speed;
}

Pacer::Clock::duration Pacer::give_up(Clock::time_point now, world::Time next) {
  if (speed_ == 0) return {};
  const Clock::duration excess = now - due(next) - most_lag;
  if (excess <= Clock::duration::zero()) return {};
  origin_ += excess;
  return excess;
}

}  // namespace server

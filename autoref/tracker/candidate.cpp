#include "autoref/tracker/candidate.h"

namespace tracker {
namespace {

using namespace std::chrono_literals;

constexpr double slack = 0.02;                // [m] noise and camera calibration on top of the speed; ours
constexpr double straightness = 0.06;         // [m] of the third sighting; 1 g would bend it by 3 mm; ours
constexpr world::Duration patience = 100ms;   // six frames between two sightings; ours
constexpr world::Duration least_base = 10ms;  // of a velocity; ours
constexpr world::Duration least_span = 20ms;  // more than one frame: two cameras alone do not confirm; ours

}  // namespace

bool Candidate::continues(const Vector2d& position, world::Time time, double max_speed) const {
  if (time <= last_ || time - last_ > patience) return false;
  const double dt = world::seconds(time - last_);
  const double off = (position - position_ - velocity_ * dt).norm();
  return off <= (has_velocity_ ? straightness : max_speed * dt + slack);
}

void Candidate::add(const Vector2d& position, world::Time time) {
  if (time - newer_time_ >= least_span) {
    older_ = newer_;
    older_time_ = newer_time_;
    newer_ = position;
    newer_time_ = time;
  }
  has_velocity_ = time - older_time_ >= least_base;
  if (has_velocity_) velocity_ = (position - older_) / world::seconds(time - older_time_);
  position_ = position;
  last_ = time;
  ++count_;
}

bool Candidate::stale(world::Time now) const { return now - last_ > patience; }

bool Candidate::confirmed(int sightings) const { return count_ >= sightings && last_ - first_ >= least_span; }

}  // namespace tracker

#pragma once

#include "sim/world/geometry.h"
#include "sim/world/time.h"

namespace tracker {

using world::Vector2d;

/// A chain of sightings that one moving thing could have caused; long enough, it becomes a track.
///
/// The next sighting must be within reach at the greatest speed and, once a velocity is known, where it
/// points to. Two cameras see one thing milliseconds and centimetres apart, so a velocity needs most of a
/// frame. CMDragons' improbability filter asks for the same persistence (football.md 3.1).
class Candidate {
 public:
  Candidate() = default;
  Candidate(const Vector2d& position, world::Time time)
      : position_(position),
        first_(time),
        last_(time),
        older_(position),
        newer_(position),
        older_time_(time),
        newer_time_(time) {}

  /// True when the sighting continues the chain.
  /// @param max_speed [m/s]
  bool continues(const Vector2d& position, world::Time time, double max_speed) const;
  /// @pre continues(position, time, ...)
  void add(const Vector2d& position, world::Time time);

  /// Too old to be continued.
  bool stale(world::Time now) const;
  /// Seen `sightings` times over more than one frame.
  bool confirmed(int sightings) const;

  int count() const { return count_; }
  world::Time first_seen() const { return first_; }
  world::Time last_seen() const { return last_; }
  const Vector2d& position() const { return position_; }  ///< [m]
  const Vector2d& velocity() const { return velocity_; }  ///< [m/s] over one to two frames

 private:
  int count_ = 1;
  Vector2d position_ = Vector2d::Zero();
  Vector2d velocity_ = Vector2d::Zero();
  world::Time first_;
  world::Time last_;
  bool has_velocity_ = false;
  // sightings at least `least_span` apart, between which velocity is measured
  Vector2d older_ = Vector2d::Zero();
  Vector2d newer_ = Vector2d::Zero();
  world::Time older_time_;
  world::Time newer_time_;
};

}  // namespace tracker

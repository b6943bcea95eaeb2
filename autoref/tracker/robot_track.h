#pragma once

#include <optional>

#include "autoref/tracker/camera_preference.h"
#include "autoref/tracker/candidate.h"
#include "autoref/tracker/robot_filter.h"
#include "sim/world/tracked_frame.h"

namespace tracker {

/// Follows one robot id: its filter while it is known, and whoever claims to be it elsewhere.
///
/// The filter stays at the last sighting; what is published is foretold from there, so sightings that arrive
/// late but in order for this robot still count.
class RobotTrack {
 public:
  RobotTrack(world::RobotId id, const Params& params);

  /// Takes in one sighting; one that contradicts the track starts or continues a candidate.
  /// @param heading [rad]; nothing when the camera could not tell
  void see(const Vector2d& position, std::optional<double> heading, world::Time time, int camera);

  /// What the robot was told to do, in the field frame [m/s]; nothing when that is not known.
  void command(std::optional<Vector2d> velocity) { commanded_ = velocity; }

  bool known() const { return known_; }
  Vector2d velocity() const { return filter_.velocity(); }                  ///< [m/s] when last seen
  double velocity_variance() const { return filter_.velocity_variance(); }  ///< [m^2/s^2] per axis
  /// Distance of a sighting from where the robot is expected [m]; zero when it is not known.
  double surprise(const Vector2d& position, world::Time time) const;
  bool seen_since(world::Time time) const { return known_ && seen_ > time; }
  /// Forgets a robot that was unseen too long.
  void age(world::Time now);
  void reset() { known_ = false, candidate_.reset(), odd_headings_ = 0; }

  /// Where it should be at an instant.
  /// @pre known()
  void foretell(world::Time time, world::TrackedRobot& out) const;

 private:
  bool follow(const Vector2d& position, std::optional<double> heading, world::Time time, int camera);

  Params params_;
  world::RobotId id_;
  RobotFilter filter_;
  std::optional<Vector2d> commanded_;  // [m/s]
  bool known_ = false;
  world::Time seen_;
  CameraPreference camera_;
  int odd_headings_ = 0;  // in a row
  std::optional<Candidate> candidate_;
};

}  // namespace tracker

#pragma once

#include <span>
#include <vector>

#include "autoref/tracker/ball_track.h"
#include "autoref/tracker/camera_bias.h"
#include "autoref/tracker/params.h"
#include "autoref/tracker/robot_track.h"
#include "sim/world/detection.h"
#include "sim/world/field.h"
#include "sim/world/tracked_frame.h"

namespace tracker {

/// The velocity a robot was told to drive at, by whoever knows: it helps while the robot changes its speed.
struct CommandedVelocity {
  world::RobotId id;
  Vector2d velocity = Vector2d::Zero();  ///< [m/s] field frame; of the command that moves it now
};

/// One belief about ball and robots from all cameras: detections in, a tracked frame out.
///
/// Every camera image is a measurement at its own capture time, taken in order of time; overlapping cameras
/// are merged by the filters themselves (paper, 5.2). Nothing from outside can stop it: unknown ids, NaN,
/// repeated or late images, floods of balls and jumps of the clock are dropped or survived.
///
/// Time    A frame's time is the newest capture time and strictly increases. A batch that jumps forward is
///         believed at once. A jump back by more than `max_step` is believed when three batches in a row say
///         so (a log that starts again): then everything is forgotten and time starts anew.
class Tracker {
 public:
  explicit Tracker(world::Geometry geometry, Params params = {});

  /// Takes in all images of one tick, in any order.
  /// @param commands  of the robots whose commands are known; not needed
  /// @return the frame for the newest capture time; null when nothing in it is newer than the last frame.
  ///         Valid until the next call.
  const world::TrackedFrame* update(std::span<const world::Detection> detections,
                                    std::span<const CommandedVelocity> commands = {});

  /// The last frame; empty before the first.
  const world::TrackedFrame& frame() const { return frame_; }

  /// Where each camera sees things beside where all together see them.
  const CameraBias& bias() const { return bias_; }

  /// How often time was found to start anew.
  int restarts() const { return restarts_; }

 private:
  struct CameraClock {
    int camera = 0;
    world::Time last;
  };

  struct Sighting {  // as the camera reported it, for comparing cameras
    int camera = 0;
    world::Time time;
    Vector2d position = Vector2d::Zero();  // [m]
  };

  void choose(std::span<const world::Detection> detections);
  bool repeats(const world::Detection& detection);
  void take_in(const world::Detection& detection);
  void see_balls(const world::Detection& detection, const Vector2d& bias);
  struct Comparison {  // of two cameras
    int camera = 0, other = 0;
    Vector2d difference = Vector2d::Zero();  // [m]
    double variance = 0;                     // [m^2]
  };
  void compare(std::optional<Sighting>& last, const Sighting& now, const Vector2d& velocity,
               double velocity_variance, double sigma);
  void foretell_robots(world::Time time, std::vector<world::TrackedRobot>& out) const;
  void publish(world::Time time, world::Time before);
  void reset();

  Params params_;
  std::vector<RobotTrack> robots_;  // by team, then number
  BallTrack ball_;
  CameraBias bias_;
  std::vector<std::optional<Sighting>> robot_sightings_;  // the last of each robot
  std::optional<Sighting> ball_sighting_;
  world::TrackedFrame frame_;
  bool started_ = false;
  bool commanded_ = false;         // some track has a command
  world::Time compared_;           // when cameras were last compared
  bool comparing_ = false;         // they are in this batch
  int batches_from_the_past_ = 0;  // in a row
  int restarts_ = 0;
  std::vector<CameraClock> cameras_;

  // Scratch, kept to save allocations.
  std::vector<const world::Detection*> images_;
  std::vector<world::DetectedBall> balls_;
  std::vector<world::TrackedRobot> foretold_;
  std::vector<Comparison> comparisons_;
};

}  // namespace tracker

#pragma once

#include <optional>
#include <span>
#include <vector>

#include "autoref/tracker/ball_filter.h"
#include "autoref/tracker/camera_preference.h"
#include "autoref/tracker/candidate.h"
#include "autoref/tracker/hidden_ball.h"
#include "autoref/tracker/kick_study.h"
#include "sim/world/detection.h"
#include "sim/world/tracked_frame.h"

namespace tracker {

/// True when the ball's centre is where a dribbler holds it: geometry only.
bool in_dribbler_zone(const world::TrackedRobot& robot, const Vector2d& ball);

/// Follows the one ball among all that cameras report.
///
/// A report belongs to the ball when some phase of its motion expects it; when it does not, but a robot, a
/// wall or a goal could have struck the ball on the way, the ball was kicked and its velocity starts anew;
/// else it is another ball or a teleport, and a candidate that must persist. A kick near a robot is studied:
/// when the ball turns out to fly, what is published is in space until its hops end.
class BallTrack {
 public:
  BallTrack(const world::Geometry& geometry, const Params& params);

  /// Takes in all balls of one camera image.
  /// @param robots  foretold to `time`
  void see(std::span<const world::DetectedBall> balls, world::Time time, int camera,
           std::span<const world::TrackedRobot> robots);

  /// Forgets a ball that was unseen too long; one that is hidden goes along with the robot that hides it.
  /// @param robots  foretold to `now`
  void age(world::Time now, std::span<const world::TrackedRobot> robots);
  void reset();

  bool known() const { return known_; }
  bool seen_since(world::Time time) const { return known_ && seen_ > time; }
  /// The report of the last image that was the ball, when it lay or rolled; for comparing cameras.
  struct Match {
    Vector2d position = Vector2d::Zero();  ///< [m]
    Vector2d velocity = Vector2d::Zero();  ///< [m/s] of the ball
    double velocity_variance = 0;          ///< [m^2/s^2]
  };
  const std::optional<Match>& match() const { return match_; }
  /// Where it should be at an instant; while unseen, with the robot that had it at its dribbler.
  /// @param robots  foretold to `time`
  world::TrackedBall foretell(world::Time time, std::span<const world::TrackedRobot> robots) const;

 private:
  bool follow(std::span<const world::DetectedBall> balls, world::Time time, int camera,
              std::span<const world::TrackedRobot> robots);
  void consider(const Vector2d& position, world::Time time);
  void take_over();
  std::optional<BallFilter::Motion> concealed(std::span<const world::DetectedBall> balls, world::Time now,
                                              std::span<const world::TrackedRobot> robots) const;
  Vector2d whole(const Vector2d& seen, const world::Camera& camera,
                 std::span<const world::TrackedRobot> robots) const;
  void hide(world::Time now, std::span<const world::TrackedRobot> robots);
  const world::Camera* camera_of(int id) const;
  std::optional<Vector3d> lifted(const Vector2d& seen, world::Time time, const world::Camera& camera) const;
  void study(const Vector2d& measured, world::Time time, const world::Camera* camera,
             const KickStudy::Surroundings& around);
  bool could_be_struck(const Vector2d& from, const Vector2d& to,
                       std::span<const world::TrackedRobot> robots) const;
  std::optional<world::RobotId> robot_below(world::Time time,
                                            std::span<const world::TrackedRobot> robots) const;
  struct Strike {
    bool possible = false;
    std::optional<world::RobotId> by{};  // nothing: a wall or the goal
  };
  Strike struck_in_the_air(world::Time time, std::span<const world::TrackedRobot> robots) const;
  void remember_hold(std::span<const world::TrackedRobot> robots);

  world::Geometry geometry_;
  world::Field field_;
  Params params_;
  BallFilter filter_;
  bool known_ = false;
  world::Time seen_;
  CameraPreference camera_;
  bool held_ = false;  // at a dribbler when it was last seen
  HiddenBall hidden_;  // active while nobody sees it and robots are why
  std::optional<KickStudy> study_;
  std::optional<Match> match_;
  Vector2d measured_ = Vector2d::Zero();  // [m] the last sighting that was used
  int measured_by_ = -1;                  // its camera
  bool beside_robot_ = false;             // and whether a robot may have hidden a part of it
  std::vector<Candidate> candidates_;
};

}  // namespace tracker

#pragma once

#include <optional>

#include "sim/world/field.h"
#include "sim/world/game_state.h"
#include "sim/world/tracked_frame.h"

namespace detectors {

// Small questions that several detectors ask.

/// The ball on the ground plane [m].
inline world::Vector2d on_ground(const world::TrackedBall& ball) { return ball.position.head<2>(); }

/// Where the ball was seen in this frame; nothing when no camera saw it.
inline std::optional<world::Vector2d> observed_ball(const world::TrackedFrame& frame) {
  if (!frame.ball || !frame.ball->observed) return std::nullopt;
  return on_ground(*frame.ball);
}

/// From the robot's hull to a point [m]; negative inside. The laws measure distances to the ball so.
inline double hull_distance(const world::Field& field, const world::TrackedRobot& robot,
                            const world::Vector2d& point) {
  return (robot.position - point).norm() - field.robot_radius;
}

/// From the robot's hull, a disc cut off by its flat front, to the ball's surface on the ground [m]; negative
/// when they overlap, as noise makes them.
double gap_to_ball(const world::Field& field, const world::TrackedRobot& robot, const world::Vector2d& ball);

/// Whether the robot holds or pushes the ball: at its front and moving with it, or hidden there.
///
/// Limits  gap 15 mm, speed across the contact 0.3 m/s: the noise of filter and cameras (ours).
bool carries(const world::Field& field, const world::TrackedRobot& robot, const world::TrackedBall& ball);

/// The robot whose hull is nearest to the point, of one team or of both; null when there is none.
const world::TrackedRobot* nearest_robot(const world::TrackedFrame& frame, const world::Vector2d& point,
                                         std::optional<world::Team> team = std::nullopt);

/// The robot whose centre is farthest over the halfway line on the opponents' side;
/// nothing when all are at home.
///
/// The centre, not the hull: the kicker stands at the ball, on the line (ours).
std::optional<world::RobotId> robot_in_wrong_half(const world::TrackedFrame& frame,
                                                  const world::GameState& state);

/// The last touch at or before `time`: of this frame, or else the one the game remembers.
std::optional<world::Touch> last_touch(const world::TrackedFrame& frame, const world::GameState& state,
                                       world::Time time);

/// Whether the touch was of a ball in play: after play began and before the whole ball was out (I-33).
bool in_play(const world::Field& field, const world::GameState& state, const world::Touch& touch);

/// How far the hull of a robot at that place reaches into a defense area [m]; negative outside, more than two
/// radii when the robot is wholly inside.
double depth_in_area(const world::Field& field, world::Side side, const world::Vector2d& robot);

/// The goalie that has the ball within 15 mm of its hull, 30 mm when nobody sees it, in its own defense area.
std::optional<world::RobotId> keeper_with_ball(const world::Field& field, const world::TrackedFrame& frame,
                                               const world::GameState& state);

/// Whether robots must behave as under STOP (Table 1: GOAL too).
inline bool is_stop(const world::GameState& state) {
  return state.command.kind == world::CommandKind::Stop || state.command.kind == world::CommandKind::Goal;
}

/// Whether a ball can have gone from one place to the other: at most 12 m/s (a robot kicks with 10 m/s at
/// most; 12 m/s is TIGERs' cap, reference "football" 4.2) and 0.1 m for the errors of a filter that is
/// catching up (ours).
bool plausible_step(const world::Vector2d& from, const world::Vector2d& to, world::Duration between);

/// Whether the ball is in the mouth or the inside of a goal: behind the goal line, between the posts, in
/// front of the back wall. `margin` [m] widens it to the back.
bool in_goal(const world::Field& field, const world::Vector2d& ball, double margin);

/// A place where the whole ball left the field.
struct Crossing {
  world::Vector2d point;   ///< [m] of the ball's centre, one ball radius outside the line
  bool goal_line = false;  ///< or else a touch line
  bool in_mouth = false;   ///< between the posts
};

/// Where a ball going straight between two places left the field; when `from` is outside as well, the point
/// of the boundary nearest to `to`.
///
/// @pre `to` is outside by more than the ball's radius
Crossing crossing(const world::Field& field, const world::Vector2d& from, const world::Vector2d& to);

}  // namespace detectors

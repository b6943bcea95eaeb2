#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "autoref/touch/views.h"
#include "sim/world/field.h"
#include "sim/world/tracked_frame.h"

namespace touch {

/// What is assumed of noise, contact and free motion: ours, set on simulated games. What comes out hardly
/// depends on them (README, Measured).
struct LikelihoodParams {
  // Near or not.
  double visit = 0.1;  ///< [m] gap at which the ball is near robots, and farthest that one is asked about
  double prior = 0.5;  ///< odds of contact between two images for a robot at gap zero

  // The gap of a contact, which is zero in truth, as seen [m]. Without contact any gap up to `visit` is as
  // likely as another.
  double gap_sigma = 0.001;
  double inside_sigma = 0.003;  ///< more of it for a ball that seems to be inside
  /// [s] more of it per m/s of the change of velocity: an image is a moment, too
  double gap_per_speed = 0.002;
  double far_share = 0.3;        ///< of contacts are seen less well: the robot hides a part of the ball
  double far_sigma = 0.006;      ///< [m] more of it for those
  double tracked_sigma = 0.006;  ///< [m] of a tracked frame's ball that stands for an image's

  // The change of velocity by a contact [m/s].
  double soft_push = 0.15;    ///< along the normal, of a ball that is carried or grazed
  double hard_push = 2.0;     ///< of one that bounces or is kicked
  double tangent = 0.4;       ///< sideways, per push
  double pull_share = 0.1;    ///< of contacts do not push but pull
  double rest_share = 0.3;    ///< of contacts change nothing: the ball lies against the robot
  double rest_speed = 0.3;    ///< and moves with it
  double grip_reach = 0.02;   ///< [m] a dribbler's bar grips the ball before it is at the plate
  double grip_share = 0.5;    ///< of balls so near that are gripped
  double grip_pull = 0.1;     ///< per axis, what this does
  double misfit_share = 0.2;  ///< of the change times a tick, how far a piece may be bent: [m]

  // And without one.
  double slide = 3.0;           ///< [m/s^2] the strongest friction
  double free_extra = 0.01;     ///< per axis, besides noise and friction
  double hiding = 0.04;         ///< [m] gap at which a robot hides a part of the ball, now and then
  double hidden_share = 0.2;    ///< of windows then
  double hidden_sigma = 0.15;   ///< per axis, what this looks like
  double free_outliers = 0.02;  ///< share of windows that break for another reason: wall, false ball
  double outlier_sigma = 0.5;   ///< per axis, of those
  double air_sigma = 0.25;      ///< per axis, of a ball in the air, as projected

  double flies_on = 0.8;  ///< chance that it is in the air for a while after it was known to be,
  world::Duration after_flight = std::chrono::milliseconds{350};  ///< when its hops are lost sight of
  double flight_gap = 0.04;  ///< [m] from a robot, in space, a ball in flight has passed it
  double struck = 0.9;       ///< probability of a touch when a flying ball changed its course at a robot
  double too_high = 0.9;     ///< of balls in the air are too high for contact

  double just_out = 0.03;  ///< [m] beyond the line a touch is no more the last before it, whatever its date

  // Nobody sees the ball.
  double hidden_touch = 0.25;  ///< chance that the robot at which it is believed to be touches it in a frame
  double hidden_gap = 0.03;    ///< [m] of such a robot

  // A visit as a whole.
  double least_prior = 0.02;   ///< of what the windows said, before courses are compared
  double unseen_touch = 0.02;  ///< chance that the windows were wrong about a robot
  double trace_sigma = 0.02;   ///< [m] gap at which a robot may have touched a ball that was hidden then
  double no_origin = 0.002;    ///< fit of a robot from which the course does not come
  double least_fit = 0.02;     ///< of the best robot; less, and the course tells nothing (a hop, a bounce)
  double bent = 0.05;          ///< and of nobody: a course that was bent by hiding, spin or a post
};

/// Six sightings of one camera as two straight pieces, d5 d4 d3 and d2 d1 d0.
struct Broken {
  Vector2d before = Vector2d::Zero();  ///< [m/s] velocity of the older piece
  Vector2d after = Vector2d::Zero();   ///< [m/s] of the newer one
  double sigma = 0;                    ///< [m/s] per axis, of their difference from noise alone
  double share = 0.5;                  ///< [0, 1] of the way from d3 to d2 where they come closest
  Vector2d place = Vector2d::Zero();   ///< [m] there
  double misfit = 0;   ///< [m] the rms distance of samples from pieces, and of the pieces there
  double seconds = 0;  ///< [s] from the middle of one piece to that of the other
};
Broken fit(const View& view, double noise);

/// A robot at the break.
struct NearRobot {
  double gap = 0;                        ///< [m] hull to ball
  Vector2d normal = Vector2d::Zero();    ///< from the robot to the ball
  Vector2d velocity = Vector2d::Zero();  ///< [m/s]
  bool at_dribbler = false;              ///< the ball is before the front plate
};

/// Density of the change of velocity if nobody touched the ball [(m/s)^-2].
/// @param airborne  probability that it is in the air
/// @param near      a robot is so near that it may hide a part of the ball
double free_density(const Broken& broken, double airborne, bool near, const LikelihoodParams& params);

/// The same if a robot did, times the odds that it did.
/// @param noise  [m] of a sighting, per axis
/// @param free   the density of free motion
double contact_density(const Broken& broken, const NearRobot& robot, double noise, double free,
                       const LikelihoodParams& params);

/// Density of the change between the courses before and after the ball was near robots,
/// if none of them touched it.
double passed_freely(const Course& before, const Course& after, double noise, const LikelihoodParams& params);

/// The same if one did.
double passage_changed(const Course& before, const Course& after, const LikelihoodParams& params);

}  // namespace touch

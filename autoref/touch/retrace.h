#pragma once

#include <array>

#include "autoref/touch/trail.h"
#include "sim/world/field.h"

namespace touch {

/// What is assumed of touches when the ball's way is gone through again: ours, set on simulated games.
struct RetraceParams {
  // Deceleration [m/s^2], how far from it, and across: a ball slides after a touch, often with spin.
  double slide_friction = 2.0, slide_sigma = 1.6, slide_curve = 0.9;
  double roll_friction = 0.6, roll_sigma = 0.8, roll_curve = 0.35;
  double slide_least = 0.05;      ///< [s] so long it slides at least,
  double slide_per_speed = 0.12;  ///< [s] and longer for each m/s
  double spin_sigma = 1.0;        ///< [m/s^2] of a ball that slides, when its spin is known,
  double hop_sigma = 1.0;         ///< and of one that hops
  double air_sigma = 6;           ///< [m/s^2] of a projected flight
  double beside = 0.04;           ///< [m] a robot so near hides a part of the ball now and then,
  double beside_sigma = 0.0016;   ///< [m] and this is what it does
  double switch_sigma = 0.003;    ///< [m] between cameras
  double outliers = 1e-3;         ///< share of sightings that are none of this ball,
  double rough = 0.2;             ///< and of those that are off by more than the courses foretell:
  double wide = 4;                ///< so many times more
  double hull_sigma = 0.0015;     ///< [m] of a hull in an image
  double touch = 0.5;             ///< weight of a touch at gap zero
  double bounce = 0.35, carry = 0.25, graze = 0.15, kick = 0.25, grip = 0.1,
         wild = 0.05;             ///< shares of touches
  double other_bounce = 0.25;     ///< and of those that bounce otherwise, with a spin that nobody knows
  double restitution = 0.57;      ///< of a hull: ER-Force's 0.6 between 46 g and 2.5 kg
  double dead_restitution = 0.1;  ///< of a turning dribbler: between ER-Force's 0.2 and TIGERs' 0
  double dead = 0.5;              ///< share of balls at a front that meet one
  double bounce_sigma = 0.1;      ///< of the way into a hull, what comes out more or less,
  double bounce_side = 0.1;       ///< and sideways
  double air_gap = 0.012;         ///< [m] of a projected flight
  double recoil = 1.0;            ///< of the way into a hull, how far off a ball may come out
  double dwell = 0.0042;          ///< [s] from meeting a hull to turning round, at most
  double reach = 0.02;            ///< [m] of kicker and dribbler before the front
  double free_break = 1e-4;       ///< weight of a break without a robot,
  double post_break = 0.1;        ///< and near a post
  double overlap_floor = 0.05;    ///< least chance that a ball seen in a hull has not touched it
};

/// Who touched the ball last, after the whole of its way is known.
struct Retraced {
  std::array<double, robot_slots> probability{};
  std::array<world::Time, robot_slots> time{};  ///< of the last touch, for those with a probability
  std::array<Vector2d, robot_slots> place{};    ///< [m] ball at that time
};

/// Goes through the trail from its oldest point with many hypotheses: each is a last toucher, and a course of
/// the ball with its covariance (a Kalman filter). Between two points every robot that a course meets, or
/// nearly, may have touched the ball, in one of several ways, at one of several instants; the points that
/// follow decide. A touch of a ball that is out changes its course, but not who touched it last before.
/// Source  Blackman, "Multiple hypothesis tracking for multiple target tracking", IEEE AESM, 2004.
/// @param noise  [m] of a sighting, per axis
Retraced retrace(const Trail& trail, const world::Field& field, double noise,
                 const RetraceParams& params = {});

}  // namespace touch

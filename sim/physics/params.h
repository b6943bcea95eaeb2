#pragma once

#include "sim/world/time.h"

namespace physics {

/// Standard gravity [m/s^2].
inline constexpr double gravity = 9.81;

/// The ball and its contact with the carpet. Numbers: reference "football", section 5.
struct BallParams {
  double mass = 0.046;              ///< [kg] golf ball (paper, 3.1)
  double radius = 0.0215;           ///< [m] (paper, 3.1); World takes it from the field
  double slide_deceleration = 3.0;  ///< [m/s^2] TIGERs
  double roll_deceleration = 0.26;  ///< [m/s^2] TIGERs
  double restitution = 0.5;         ///< normal to the carpet; published .47 (TIGERs) to .57 (ER-Force)
  double bounce_friction = 0.35;    ///< Coulomb friction during a bounce; ER-Force's ball on floor
  double smallest_hop = 0.010;      ///< [m] lower hops become rolling; TIGERs
  /// [rad/s^2] of spin about the vertical; ours: 2/3 of Coulomb friction .35 on a contact patch of 5 mm
  /// radius gives 53
  double pivot_deceleration = 50.0;
};

/// Restitution and friction of a ball with what it hits; Bullet multiplies one number of each body.
struct ContactParams {
  double ball_robot_restitution = 0.6;      ///< ER-Force
  double ball_dribbler_restitution = 0.1;   ///< at a turning dribbler; ours: between ER-Force .2 and TIGERs 0
  double ball_wall_restitution = 0.3;       ///< ER-Force
  double ball_goal_side_restitution = 0.3;  ///< ER-Force
  double ball_goal_back_restitution = 0.1;  ///< ER-Force
  double ball_robot_friction = 0.22;        ///< ER-Force
  double ball_wall_friction = 0.35;         ///< ours: as on the carpet
  double ball_goal_friction = 0.5;          ///< ER-Force
  double robot_robot_restitution = 0.1;     ///< ours: plastic covers hardly bounce; Sumatra damps by 0.8
  double robot_robot_friction = 0.1;        ///< Sumatra, tangential coupling
};

/// When the kicker reaches the ball, and how often.
struct KickerParams {
  double reach = 0.008;        ///< [m] gap between front and ball; ours: two substeps of closing at 1 m/s
  double highest_ball = 0.05;  ///< [m] ball centre; ER-Force
  double recharge = 0.1;       ///< [s] ER-Force
  double steepest = 1.4;  ///< [rad] largest elevation of a chip; ours (80 degrees): protects against nonsense
};

/// The dribbler as a bounded spring between ball and bar.
///
/// Source  ours. The bar can pull as hard as carpet friction on the back-spinning ball allows
///         (.35 g = 3.4 m/s^2, and more because the bar also presses down), and drag sideways as hard as
///         rubber allows (friction 1.5 in ER-Force's model). The turn rates and decelerations at which the
///         ball is then lost are measured in tests/sim/physics/dribbler_test.cpp and given in the README.
struct DribblerParams {
  double reach = 0.015;        ///< [m] gap over which the bar still grips
  double gain = 30.0;          ///< [1/s] of the spring: closes an error in about 8 substeps
  double pull = 5.0;           ///< [m/s^2] largest acceleration towards the robot
  double drag = 6.0;           ///< [m/s^2] largest acceleration sideways
  double full_speed = 50.0;    ///< [rad/s] of the bar from which on the grip is full; below in proportion
  double highest_ball = 0.03;  ///< [m] ball centre; a bouncing ball is not held
  double same_capture = 0.1;   ///< [s] a ball back within this time was not captured anew; ours
  double bar_radius = 0.007;   ///< [m] ER-Force
  double fastest_bar = 150;    ///< [rad/s] ER-Force: 49 rad/s of backspin
  /// [rad/s^2] of the ball; ours: 5/2 of 8.6 m/s^2 at its surface, which is `drag` and what the carpet
  /// takes (3) less a little: full in 0.05 s
  double spin_up = 1000;
};

/// A ball that came to lie on a robot or a goal.
struct PerchParams {
  double roll_deceleration = 0.3;  ///< [m/s^2] on a robot's flat cover; ours: as on the carpet
  double push = 1.0;  ///< [m/s^2] off a goal's roof; ours: a roof sloping by 6 degrees, so none stays there
};

/// How far actuators miss what was asked of them. All zero: perfect.
///
/// Drawn from streams of their own for each robot, named "actuators <team> <number>": what one robot does
/// never shifts another's luck (see actuators.h). The presets are in sim/engine/realism.cpp.
///
/// What is published:
/// - RoboJackets evaluate their shots with 0.04 rad (KickEvaluator, kick_std_dev), aiming included.
/// - They (robocup-software issue 422) and others (robot-soccer-kit issue 73) say that kicks vary from robot
///   to robot, without numbers.
/// - UBC Thunderbots (Software issue 2903) say that a dribbled ball is lost sooner backwards and sideways.
/// - No simulator of the league scatters kicks.
/// The values in brackets are those of "measured", with the reason where nothing is published.
struct ActuatorErrors {
  /// [rad] of each kick and chip (.02: half of RoboJackets' .04, whose other part, aiming,
  /// our teams do themselves)
  double kick_direction_sigma = 0;
  /// share of the commanded speed, each kick and chip (.03, ours: speed goes with the capacitor's voltage,
  /// known to 1 or 2 %, and with where it hits)
  double kick_speed_sigma = 0;
  /// [rad] of elevation, each chip (.03, ours: a ball 0.6 mm higher on the shovel)
  double chip_angle_sigma = 0;
  /// probability that the kicker fires without reaching the ball (.005, ours:
  /// one in some four games' kicks of a robot)
  double misfire = 0;
  /// share of the dribbler's grip, anew for each capture (.1, ours: rubber and dust)
  double grip_sigma = 0;
  /// share of the speed driven; one factor per robot and game (.01, ours: half a millimetre of
  /// wear on wheels of 50 mm)
  double speed_sigma = 0;
  /// share of acceleration and braking; one factor per robot and game (.03, ours: battery and weight)
  double acceleration_sigma = 0;
  /// [rad/m] turn per metre driven; one number per robot and game (.01, ours: 1 % between wheels 160 mm apart
  /// is .06 without a gyroscope)
  double heading_drift_sigma = 0;
};

/// Bullet's settings (reference "physics", 1c, 1d).
struct SolverParams {
  int iterations = 10;
  double split_impulse_threshold = -0.0005;  ///< [m] near zero, or deep overlaps turn into speed
  double hull_margin = 0.001;                ///< [m] convex margin, inside the nominal surface
  int hull_segments = 14;                    ///< straight pieces of the round part of a robot
  /// [s] of World::substep; the engine needs the default, others are for the study in the README
  double substep_length = world::substep_length;
};

struct Params {
  BallParams ball;
  ContactParams contact;
  KickerParams kicker;
  DribblerParams dribbler;
  PerchParams perch;
  ActuatorErrors actuators;
  SolverParams solver;
};

}  // namespace physics

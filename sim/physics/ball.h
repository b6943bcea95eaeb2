#pragma once

#include "sim/physics/params.h"
#include "sim/truth/truth.h"

namespace physics {

/// Says whether the ball lies on the carpet: no gravity, but friction.
bool on_ground(const truth::Ball& ball, const BallParams& params);

/// Changes velocity and spin of a ball on the carpet by the friction of `duration` seconds; position stays.
///
/// Slides with deceleration a_s against the slip u = v + spin x (-r z) while the spin increases; u shrinks at
/// 7/2 a_s in a fixed direction, so the end of sliding is known. Then rolls (u = 0) with a_r until rest.
/// Exact for any duration. From rest spin the rolling speed is 5/7 of the kick (solid sphere).
void apply_ground_friction(truth::Ball& ball, double duration, const BallParams& params);

/// Brings a ball that ended a step below the carpet back through its bounce; others stay as they are.
///
/// The instant of the impact follows from height and speed under gravity alone, and the rest of the step is
/// flown upwards again, so bounce heights do not depend on the step. Tangentially an impulse of at most
/// bounce_friction (1 + e) |v_z| acts against the slip, and no more than what ends it (2/7 of it).
void bounce(truth::Ball& ball, const BallParams& params);

/// Distance to rest [m] of a ball kicked without spin at `speed` [m/s] along the carpet, in closed form.
double rolling_distance(double speed, const BallParams& params);

}  // namespace physics

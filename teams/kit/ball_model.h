#pragma once

#include "sim/world/field.h"
#include "teams/kit/view.h"

namespace kit {

/// Where a ball on the carpet will be: it slides (strong deceleration) until its speed has fallen to
/// `rolls_below`, then rolls (weak deceleration) to rest, along a straight line.
///
/// Source  two-phase model of SSL-Vision's geometry message (reference "football", 2.4).
struct BallModel {
  double slide_deceleration = 3.0;  ///< [m/s^2]
  double roll_deceleration = 0.26;  ///< [m/s^2]
  double switch_ratio = 5.0 / 7.0;  ///< rolling begins at this share of the kick's speed

  BallModel() = default;
  explicit BallModel(const world::Geometry& geometry)
      : slide_deceleration(geometry.ball_slide_deceleration),
        roll_deceleration(geometry.ball_roll_deceleration),
        switch_ratio(geometry.ball_switch_ratio) {}

  /// Distance covered [m] after `time` [s] from `speed` [m/s].
  double distance_after(double speed, double rolls_below, double time) const;
  /// Speed [m/s] after `time` [s].
  double speed_after(double speed, double rolls_below, double time) const;
  /// Time to cover `distance` [m]; infinite when the ball stops before.
  double time_to_cover(double speed, double rolls_below, double distance) const;
  /// Distance until it lies still [m].
  double stopping_distance(double speed, double rolls_below) const;
  /// Speed of a flat kick [m/s] with which the ball still has `arrival` [m/s] after `distance` [m].
  double kick_speed_for(double distance, double arrival) const;
};

}  // namespace kit

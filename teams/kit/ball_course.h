#pragma once

#include <array>

#include "teams/kit/ball_model.h"

namespace kit {

/// Where a ball will be, on the carpet or in the air: a straight line seen from above,
/// hops seen from the side.
///
/// In the air gravity alone. Each landing keeps half of the climb; the first takes from the speed
/// along the ground what friction gives until the ball rolls, min(2/7 v, .35 * 1.5 * climb).
/// A hop lower than 10 mm is rolling.
///
/// Source  numbers as in the simulator's ball (sim/physics/params.h: .5, .35, 10 mm)
class BallCourse {
 public:
  BallCourse(const Ball& ball, const BallModel& model);

  Vector2d position(double time) const { return from_ + along_ * distance(time); }
  double distance(double time) const;                  ///< along the ground [m] after `time` [s]
  double speed(double time) const;                     ///< along the ground [m/s]
  double height(double time) const;                    ///< [m] above its resting place
  double climb(double time) const;                     ///< [m/s]
  double rolls_below() const { return rolls_below_; }  ///< [m/s] once it is on the ground
  const Vector2d& along() const { return along_; }     ///< unit vector; null for a ball at rest
  bool flies() const { return hops_ > 0; }
  double lands_after() const { return hops_ > 0 ? arcs_[0].duration : 0; }  ///< [s] until the first landing

 private:
  struct Arc {
    double duration = 0, speed = 0, height = 0, climb = 0;  // at its beginning
  };
  // The arc at that time, with the time since it began and the distance before it; -1: on the ground by then.
  int arc_at(double& time, double& before) const;

  BallModel model_;
  Vector2d from_ = Vector2d::Zero();
  Vector2d along_ = Vector2d::Zero();
  std::array<Arc, 8> arcs_{};
  int hops_ = 0;
  double ground_speed_ = 0;  // when it begins to roll or slide
  double rolls_below_ = 0;
};

/// The ball `time` seconds later.
Ball predicted(const Ball& ball, const BallModel& model, double time);

}  // namespace kit

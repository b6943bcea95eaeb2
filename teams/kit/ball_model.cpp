#include "teams/kit/ball_model.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kit {

double BallModel::distance_after(double speed, double rolls_below, double time) const {
  double distance = 0;
  if (speed > rolls_below) {
    const double sliding = std::min(time, (speed - rolls_below) / slide_deceleration);
    distance += speed * sliding - 0.5 * slide_deceleration * sliding * sliding;
    speed -= slide_deceleration * sliding;
    time -= sliding;
  }
  const double rolling = std::clamp(time, 0.0, speed / roll_deceleration);
  return distance + speed * rolling - 0.5 * roll_deceleration * rolling * rolling;
}

double BallModel::speed_after(double speed, double rolls_below, double time) const {
  if (speed > rolls_below) {
    const double sliding = std::min(time, (speed - rolls_below) / slide_deceleration);
    speed -= slide_deceleration * sliding;
    time -= sliding;
  }
  return std::max(0.0, speed - roll_deceleration * time);
}

double BallModel::time_to_cover(double speed, double rolls_below, double distance) const {
  if (distance <= 0) return 0;
  double time = 0;
  if (speed > rolls_below) {
    const double slide = (speed * speed - rolls_below * rolls_below) / (2 * slide_deceleration);
    if (distance <= slide) {
      const double end = std::sqrt(speed * speed - 2 * slide_deceleration * distance);
      return (speed - end) / slide_deceleration;
    }
    time = (speed - rolls_below) / slide_deceleration;
    distance -= slide;
    speed = rolls_below;
  }
  const double square = speed * speed - 2 * roll_deceleration * distance;
  if (square < 0) return std::numeric_limits<double>::infinity();
  return time + (speed - std::sqrt(square)) / roll_deceleration;
}

double BallModel::stopping_distance(double speed, double rolls_below) const {
  double distance = 0;
  if (speed > rolls_below) {
    distance = (speed * speed - rolls_below * rolls_below) / (2 * slide_deceleration);
    speed = rolls_below;
  }
  return distance + speed * speed / (2 * roll_deceleration);
}

double BallModel::kick_speed_for(double distance, double arrival) const {
  const double c = switch_ratio;
  // Arrives rolling: arrival^2 = c^2 v^2 - 2 a_r (D - slide), slide = (1 - c^2) v^2 / (2 a_s).
  const double square = (arrival * arrival + 2 * roll_deceleration * distance) /
                        (c * c + roll_deceleration * (1 - c * c) / slide_deceleration);
  const double slide = (1 - c * c) * square / (2 * slide_deceleration);
  if (slide <= distance) return std::sqrt(square);
  return std::sqrt(arrival * arrival + 2 * slide_deceleration * distance);  // arrives still sliding
}

}  // namespace kit

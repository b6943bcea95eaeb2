#include "teams/kit/ball_course.h"

#include <algorithm>
#include <cmath>

namespace kit {
namespace {

constexpr double gravity = 9.81;     // [m/s^2]
constexpr double restitution = 0.5;  // of the climb at a landing
constexpr double bounce_friction = 0.35;
constexpr double smallest_hop = 0.010;  // [m]

}  // namespace

BallCourse::BallCourse(const Ball& ball, const BallModel& model) : model_(model), from_(ball.position) {
  double speed = ball.velocity.norm();
  if (speed > 1e-6) along_ = ball.velocity / speed;
  ground_speed_ = speed;
  rolls_below_ = ball.rolls_below;
  if (!ball.flies) return;
  double height = std::max(ball.height, 0.0);
  double climb = ball.climb;
  bool first = true;
  while (hops_ < static_cast<int>(arcs_.size())) {
    const double highest = height + (climb > 0 ? climb * climb / (2 * gravity) : 0);
    if (highest < smallest_hop) break;
    const double landing_climb = std::sqrt(std::max(climb * climb + 2 * gravity * height, 0.0));
    arcs_[static_cast<std::size_t>(hops_)] = {(climb + landing_climb) / gravity, speed, height, climb};
    ++hops_;
    if (first && !ball.bounced) {
      speed -= std::min(speed * (1 - 5.0 / 7.0), bounce_friction * (1 + restitution) * landing_climb);
    }
    first = false;
    height = 0;
    climb = restitution * landing_climb;
  }
  ground_speed_ = speed;
  rolls_below_ = speed + 1;  // it rolls from its first landing on
}

int BallCourse::arc_at(double& time, double& before) const {
  before = 0;
  for (int i = 0; i < hops_; ++i) {
    const Arc& arc = arcs_[static_cast<std::size_t>(i)];
    if (time < arc.duration) return i;
    time -= arc.duration;
    before += arc.speed * arc.duration;
  }
  return -1;
}

double BallCourse::distance(double time) const {
  double before = 0;
  const int i = arc_at(time, before);
  if (i >= 0) return before + arcs_[static_cast<std::size_t>(i)].speed * time;
  return before + model_.distance_after(ground_speed_, rolls_below_, time);
}

double BallCourse::speed(double time) const {
  double before = 0;
  const int i = arc_at(time, before);
  if (i >= 0) return arcs_[static_cast<std::size_t>(i)].speed;
  return model_.speed_after(ground_speed_, rolls_below_, time);
}

double BallCourse::height(double time) const {
  double before = 0;
  const int i = arc_at(time, before);
  if (i < 0) return 0;
  const Arc& arc = arcs_[static_cast<std::size_t>(i)];
  return arc.height + arc.climb * time - 0.5 * gravity * time * time;
}

double BallCourse::climb(double time) const {
  double before = 0;
  const int i = arc_at(time, before);
  return i < 0 ? 0 : arcs_[static_cast<std::size_t>(i)].climb - gravity * time;
}

Ball predicted(const Ball& ball, const BallModel& model, double time) {
  Ball later = ball;
  if (ball.velocity.squaredNorm() < 1e-12 && !ball.flies) return later;
  const BallCourse course(ball, model);
  later.position = course.position(time);
  later.velocity = course.along() * course.speed(time);
  later.rolls_below = course.rolls_below();
  if (course.flies()) {
    later.height = course.height(time);
    later.climb = course.climb(time);
    later.bounced = ball.bounced || time >= course.lands_after();
    later.flies = later.height > 0 || later.climb > 0;
  }
  return later;
}

}  // namespace kit

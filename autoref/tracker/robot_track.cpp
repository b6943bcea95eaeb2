#include "autoref/tracker/robot_track.h"

#include <algorithm>
#include <cmath>

namespace tracker {
namespace {

using namespace std::chrono_literals;

constexpr double collision_sigma = 3.0;  // [m/s] a robot may stop or be pushed at its top speed at once
constexpr double spin_sigma = 20.0;      // [rad/s] its top turning speed
constexpr double max_speed = 8.0;        // [m/s] of a candidate: two robots' closing speed with reserve; ours
constexpr double heading_gate = 10.828;  // chi-square, 1 degree of freedom, 99.9 %
constexpr double wild_heading = 1.0;  // [rad] in one frame: a misread pattern, at 20 rad/s it would be 0.33
// an unseen robot moves on as before, then it is taken to stand; ours
constexpr world::Duration coasting = 150ms;

}  // namespace

RobotTrack::RobotTrack(world::RobotId id, const Params& params) : params_(params), id_(id), filter_(params) {}

void RobotTrack::see(const Vector2d& position, std::optional<double> heading, world::Time time, int camera) {
  if (known_ && follow(position, heading, time, camera)) {
    candidate_.reset();
    return;
  }
  if (candidate_ && candidate_->continues(position, time, max_speed)) {
    candidate_->add(position, time);
  } else if (!candidate_ || time > candidate_->last_seen()) {
    candidate_.emplace(position, time);
  }
  if (!candidate_->confirmed(params_.confirmations)) return;
  filter_.start(position, heading, candidate_->velocity(), 1.0);
  known_ = true;
  seen_ = time;
  camera_ = {};
  camera_.used(camera, time);
  odd_headings_ = 0;
  candidate_.reset();
}

bool RobotTrack::follow(const Vector2d& position, std::optional<double> heading, world::Time time,
                        int camera) {
  if (time < seen_) return true;  // older than what is known: nothing to learn
  RobotFilter ahead = filter_;
  const double dt = world::seconds(time - seen_);
  ahead.predict(dt);
  if (commanded_) ahead.drive(*commanded_, dt);
  const bool expected = ahead.nis(position) < params_.nis_gate;
  const double off = (position - ahead.position()).norm();
  if (!expected && off > params_.robot_gate) return false;
  if ((!expected || off > CameraPreference::agreement) && camera_.distrusts(camera, time)) return true;

  std::optional<double> new_heading;
  if (heading && ahead.heading_nis(*heading) >= heading_gate) {
    const bool wild = std::abs(world::wrap_angle(*heading - ahead.heading())) > wild_heading;
    odd_headings_ = wild ? odd_headings_ + 1 : 0;
    if (!wild || odd_headings_ >= params_.confirmations) new_heading = heading;
    heading.reset();
  } else if (heading) {
    odd_headings_ = 0;
  }

  ahead.update(position, heading);
  if (!expected) ahead.collide(position, collision_sigma);
  if (new_heading) {
    ahead.spin(*new_heading, spin_sigma);
    odd_headings_ = 0;
  }
  filter_ = ahead;
  seen_ = time;
  camera_.used(camera, time);
  return true;
}

double RobotTrack::surprise(const Vector2d& position, world::Time time) const {
  if (!known_) return 0;
  const double dt = std::max(0.0, world::seconds(time - seen_));
  return (position - filter_.position() - filter_.velocity() * dt).norm();
}

void RobotTrack::age(world::Time now) {
  if (known_ && now - seen_ > params_.robot_memory) known_ = false;
  if (candidate_ && candidate_->stale(now)) candidate_.reset();
}

void RobotTrack::foretell(world::Time time, world::TrackedRobot& out) const {
  out.id = id_;
  const world::Duration unseen = std::max(world::Duration{}, time - seen_);
  if (unseen == world::Duration{}) {  // most are seen in every frame: nothing to foretell
    out.position = filter_.position();
    out.orientation = filter_.heading();
    out.velocity = filter_.velocity();
    out.angular_velocity = filter_.angular_velocity();
    return;
  }
  const double dt = world::seconds(std::min(unseen, coasting));
  const bool moving = unseen <= coasting;
  out.position = filter_.position() + filter_.velocity() * dt;
  out.orientation = world::wrap_angle(filter_.heading() + filter_.angular_velocity() * dt);
  out.velocity = moving ? filter_.velocity() : Vector2d(Vector2d::Zero());
  out.angular_velocity = moving ? filter_.angular_velocity() : 0;
}

}  // namespace tracker

#include "autoref/touch/touch_detector.h"

#include <algorithm>
#include <cmath>

#include "autoref/touch/algorithms.h"

namespace touch {
namespace {

using namespace std::chrono_literals;

constexpr double accel_threshold = 2.0;     // [m/s^2] of accel_measure (requirements 1.10)
constexpr double accel_margin = 0.010;      // [m] hull to ball (requirements 1.10)
constexpr double line_margin = 0.030;       // [m] (paper, 6.5.2)
constexpr double backtrack_margin = 0.010;  // [m] (paper, 6.5.2)
constexpr int line_age = 2;                 // frames; also backtrack's (football.md 4.1)
// 3 frames less their jitter: line is silent after it spoke (I-23)
constexpr world::Duration line_rest = 42ms;
constexpr int accel_age = 1;         // frames: the middle one of three
constexpr int reach_frames = 3;      // ours: README, Decisions
constexpr double reach_speed = 0.3;  // [m/s] of the ball relative to the dribbler; ours
// [m/s] of the ball: one at rest tells nothing; V_b of requirements 1.10
constexpr double reach_least_speed = 0.1;
constexpr double front = 0.073;            // [m] centre to front plate (world::RobotSpecs)
constexpr double front_margin = 0.010;     // [m] plate to ball, as accel's
constexpr double front_half_width = 0.05;  // [m] dribbler zone (requirements 1.10)
constexpr double max_ball_speed = 12.0;    // [m/s] faster is a teleport (tracker::Params)
constexpr double max_step = 0.02;          // [m] what a tracker's correction may add to it; ours
constexpr double far_away = 1.0;           // [m] no algorithm looks further; ours
bool frames_vote(const world::TouchAlgorithms& algorithms) {
  return algorithms.accel || algorithms.line || algorithms.backtrack || algorithms.reach;
}

constexpr world::Duration longest_frame = 50ms;  // three frames; longer and positions are no history; ours

}  // namespace

TouchDetector::TouchDetector(const world::Geometry& geometry, world::TouchAlgorithms algorithms)
    : field_(geometry.field), algorithms_(algorithms), asked_(algorithms), last_toucher_(geometry) {
  if (!frames_vote(algorithms)) asked_ = {.accel = true, .line = true, .backtrack = true};
  found_.reserve(robot_slots);
}

void TouchDetector::reset() {
  forget_frames();
  last_toucher_.reset();
  last_found_.reset();
}

void TouchDetector::forget_frames() {
  length_ = 0;
  for (RobotHistory& history : histories_) history.length = history.carried = 0;
}

bool TouchDetector::remember(const world::TrackedFrame& frame) {
  if (!frame.ball) {
    forget_frames();
    return false;
  }
  const Vector2d ball = frame.ball->position.head<2>();
  if (length_ > 0) {
    const world::Duration step = frame.time - samples_[0].time;
    const bool is_next = step > world::Duration{} && step <= longest_frame;
    const double far = max_ball_speed * world::seconds(step) + max_step;
    if (!is_next || (ball - samples_[0].ball).norm() > far) forget_frames();
  }
  std::ranges::rotate(samples_, samples_.end() - 1);
  samples_[0] = {frame.time, ball, frame.ball->velocity.head<2>()};
  length_ = std::min(length_ + 1, memory);
  return true;
}

bool TouchDetector::carries(const world::TrackedRobot& robot) const {
  const Vector2d arm = samples_[0].ball - robot.position;
  const Vector2d local = world::rotated(arm, -robot.orientation);
  const double gap = local.x() - front - field_.ball_radius;
  if (std::abs(gap) > front_margin || std::abs(local.y()) > front_half_width) return false;
  const Vector2d carried = robot.velocity + robot.angular_velocity * Vector2d(-arm.y(), arm.x());
  const Vector2d& velocity = samples_[0].ball_velocity;
  return velocity.norm() > reach_least_speed && (velocity - carried).norm() < reach_speed;
}

void TouchDetector::remember(const world::TrackedRobot& robot, RobotHistory& history) const {
  if (length_ < 2 || history.time != samples_[1].time) history.length = history.carried = 0;
  std::ranges::rotate(history.ball_from_robot, history.ball_from_robot.end() - 1);
  history.ball_from_robot[0] = samples_[0].ball - robot.position;
  history.length = std::min(history.length + 1, memory);
  history.time = samples_[0].time;
  history.carried = carries(robot) ? history.carried + 1 : 0;
}

std::optional<int> TouchDetector::frames_since_touch(RobotHistory& history, bool is_closest) const {
  const double contact = field_.robot_radius + field_.ball_radius;
  const double over = field_.robot_radius - field_.ball_radius;
  const std::span<const Vector2d> d(history.ball_from_robot.data(), static_cast<std::size_t>(history.length));

  if (asked_.reach && history.carried >= reach_frames) return 0;
  if (asked_.accel && is_closest && length_ >= 3 && d[0].norm() < contact + accel_margin) {
    const std::array<Vector2d, 3> ball = {samples_[0].ball, samples_[1].ball, samples_[2].ball};
    if (accel_measure(ball) > accel_threshold) return accel_age;
  }
  const double inside = contact - backtrack_margin;
  if (asked_.as_coded) {
    const bool rested = !history.line_time || samples_[0].time - *history.line_time >= line_rest;
    if (asked_.line && d.size() >= 6 && rested && line_says_touch_as_coded(d, contact + line_margin)) {
      history.line_time = samples_[0].time;
      return line_age;
    }
    if (asked_.backtrack && d.size() >= 8 && backtrack_says_touch_as_coded(d, over, inside)) return line_age;
    return std::nullopt;
  }
  if (asked_.line && d.size() >= 6 && line_says_touch(d, contact + line_margin)) return line_age;
  if (asked_.backtrack && d.size() >= 4 && backtrack_says_touch(d, contact, inside)) return line_age;
  return std::nullopt;
}

void TouchDetector::update(const world::TrackedFrame& frame, std::span<const world::Detection> images,
                           std::vector<world::Touch>& out) {
  out.clear();
  ask_frames(frame);
  if (algorithms_.likelihood) last_toucher_.update(frame, images, last_found_, out);
  if (frames_vote(algorithms_)) out.insert(out.end(), found_.begin(), found_.end());
}

void TouchDetector::ask_frames(const world::TrackedFrame& frame) {
  found_.clear();
  if (!remember(frame)) return;

  const auto distance_to_ball = [this](const world::TrackedRobot& robot) {
    return (samples_[0].ball - robot.position).norm();
  };
  const auto closest = std::ranges::min_element(frame.robots, {}, distance_to_ball);
  for (const world::TrackedRobot& robot : frame.robots) {
    if (robot.id.number > world::max_robot_number || distance_to_ball(robot) > far_away) continue;
    RobotHistory& history = histories_[slot(robot.id)];
    remember(robot, history);
    if (const auto age = frames_since_touch(history, robot.id == closest->id)) {
      const Sample& then = samples_[static_cast<std::size_t>(*age)];
      found_.push_back({robot.id, then.time, then.ball});
      if (world::distance_outside_lines(field_, then.ball) <= field_.ball_radius) last_found_ = found_.back();
    }
  }
}

}  // namespace touch

#include "autoref/detectors/collision.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "autoref/detectors/ball.h"

namespace detectors {

using world::RobotId;
using world::Team;
using world::TrackedRobot;
using world::Vector2d;

namespace {

constexpr double near_contact = 1.1;  // of the distance at which hulls touch (TIGERs)
constexpr double apart = 0.05;        // [m] between hulls
constexpr world::Duration cool_down = std::chrono::seconds{2};
constexpr world::Duration known_for = std::chrono::milliseconds{200};  // ours: no robot that just appeared
constexpr world::Duration look_back = std::chrono::milliseconds{67};   // ours: four frames
constexpr world::Duration possession = std::chrono::seconds{2};        // ours

const TrackedRobot* find(const std::vector<TrackedRobot>& robots, RobotId id) {
  for (const TrackedRobot& robot : robots) {
    if (robot.id == id) return &robot;
  }
  return nullptr;
}

double angle_between(const Vector2d& a, const Vector2d& b) {
  const double product = a.norm() * b.norm();
  return product > 0 ? std::acos(std::clamp(a.dot(b) / product, -1.0, 1.0)) : 0.0;
}

}  // namespace

// Both robots go straight on from the last frame; their speeds towards each other when the hulls touch.
std::optional<Collision::Impact> Collision::impact(RobotId yellow, RobotId blue) const {
  const TrackedRobot* a = find(before_, yellow);
  const TrackedRobot* b = find(before_, blue);
  if (!a || !b) return std::nullopt;
  const Vector2d apart_by = b->position - a->position;
  const Vector2d closing = a->velocity - b->velocity;
  const double reach = 2 * field_.robot_radius;
  const double speed_squared = closing.squaredNorm();
  if (apart_by.dot(closing) <= 0) return std::nullopt;
  // |apart_by - closing t| = reach, the earlier of both solutions.
  const double nearest_time = apart_by.dot(closing) / speed_squared;
  const double miss_squared = (apart_by - closing * nearest_time).squaredNorm();
  if (miss_squared >= reach * reach) return std::nullopt;
  const double time = std::max(0.0, nearest_time - std::sqrt((reach * reach - miss_squared) / speed_squared));
  const Vector2d line = (apart_by - closing * time).normalized();
  return Impact{a->velocity.dot(line), -b->velocity.dot(line)};
}

bool Collision::believable(RobotId yellow, RobotId blue, double speed) const {
  for (const RobotId robot : {yellow, blue}) {
    if (!past_.position(robot, before_time_ - known_for)) return false;
  }
  const auto distance = [&](world::Time time) {
    return (*past_.position(blue, time) - *past_.position(yellow, time)).norm();
  };
  const double shrunk = distance(before_time_ - look_back) - distance(before_time_);
  return shrunk >= speed / 2 * world::seconds(look_back);
}

bool Collision::has_advantage(const world::TrackedFrame& frame, const world::GameState& state,
                              RobotId victim) const {
  if (!advantage_ || !frame.ball || !state.last_touch) return false;
  const bool theirs =
      state.last_touch->robot.team == victim.team && frame.time - state.last_touch->time <= possession;
  const TrackedRobot* nearest = nearest_robot(frame, on_ground(*frame.ball));
  return theirs && nearest && nearest->id.team == victim.team && nearest->id != victim;
}

Events Collision::update(const world::TrackedFrame& frame, const world::GameState& state) {
  Events events;
  const double reach = 2 * field_.robot_radius;
  for (const TrackedRobot& yellow : frame.robots) {
    if (yellow.id.team != Team::Yellow || yellow.id.number > world::max_robot_number) continue;
    for (const TrackedRobot& blue : frame.robots) {
      if (blue.id.team != Team::Blue || blue.id.number > world::max_robot_number) continue;
      Pair& pair = pairs_[yellow.id.number][blue.id.number];
      const double distance = (yellow.position - blue.position).norm();
      if (distance > reach + apart) pair.close = false;
      if (pair.close || distance > near_contact * reach) continue;
      pair.close = true;
      if (pair.reported && frame.time - *pair.reported < cool_down) continue;

      const auto hit = impact(yellow.id, blue.id);
      if (!hit) continue;
      const double speed = hit->yellow + hit->blue;
      if (speed - braking_ <= speed_ || !believable(yellow.id, blue.id, speed)) continue;
      pair.reported = frame.time;
      const Vector2d place = (yellow.position + blue.position) / 2;
      const double more = hit->yellow - hit->blue;
      const double angle =
          angle_between(find(before_, yellow.id)->velocity, find(before_, blue.id)->velocity);
      if (std::abs(more) < difference_) {
        events.push_back(
            {frame.time, world::BotCrashDrawn{{yellow.id, blue.id}, place, speed, std::abs(more), angle}});
        continue;
      }
      world::BotCrashUnique crash;
      crash.by = more > 0 ? yellow.id : blue.id;
      crash.victim = more > 0 ? blue.id : yellow.id;
      crash.location = place;
      crash.speed = speed;
      crash.speed_difference = std::abs(more);
      crash.angle = angle;
      crash.advantage = has_advantage(frame, state, crash.victim);
      events.push_back({frame.time, crash});
    }
  }
  before_ = frame.robots;
  before_time_ = frame.time;
  past_.add(frame);
  return events;
}

}  // namespace detectors

#include "experiments/judge/witness.h"

#include <algorithm>
#include <map>
#include <utility>

namespace judge {

using world::Location;
using world::TouchAlgorithms;

namespace {

constexpr double nearest_reach = 0.15;  // [m] hull centre to ball (reference football, 4.2)
constexpr std::size_t look_back = 24;   // named touches: more than there are robots

}  // namespace

Witness::Witness(std::string name, const world::Geometry& geometry, TouchAlgorithms algorithms)
    : name_(std::move(name)), field_(geometry.field), detector_(std::in_place, geometry, algorithms) {}

Witness Witness::nearest(const world::Geometry& geometry) {
  Witness witness("nearest robot", geometry, {});
  witness.detector_.reset();
  return witness;
}

void Witness::see(const world::TrackedFrame& frame, std::span<const world::Detection> images,
                  const world::GameState& state) {
  if (detector_) {
    if (frame.time <= last_frame_) detector_->reset();
    detector_->update(frame, images, found_);
  } else if (found_.clear(); frame.ball) {
    const world::Vector2d ball = frame.ball->position.head<2>();
    const auto distance = [&](const world::TrackedRobot& robot) { return (robot.position - ball).norm(); };
    const auto closest = std::ranges::min_element(frame.robots, {}, distance);
    if (closest != frame.robots.end() && distance(*closest) < nearest_reach) {
      found_.push_back({closest->id, frame.time, ball});
    }
  }
  last_frame_ = frame.time;
  const bool on = state.location == Location::GameOn;
  if (on && (location_ != Location::GameOn || state.location_time != play_began_)) {
    play_began_ = state.location_time;
    last_.reset();
    // The referee knows who took the kick, whatever the witness saw.
    if (state.kicker) {
      last_.emplace();
      last_->robot = *state.kicker;
      last_->time = state.location_time;
    }
  }
  location_ = state.location;
  for (const world::Touch& touch : found_) {  // as the referee does: detectors::BallTouched
    const bool counts = on && touch.time >= *play_began_ &&
                        world::distance_outside_lines(field_, touch.position) <= field_.ball_radius;
    keep(touch, counts);
    if (counts) last_ = touch;
  }
}

void Witness::keep(const world::Touch& touch, bool in_play) {
  const std::size_t first = named_.size() > look_back ? named_.size() - look_back : 0;
  for (std::size_t n = named_.size(); n-- > first;) {
    Named& named = named_[n];
    if (named.robot != touch.robot) continue;
    if (touch.time > named.end + TrueTouches::apart || touch.time < named.begin - TrueTouches::apart)
      continue;
    named.begin = std::min(named.begin, touch.time);
    named.end = std::max(named.end, touch.time);
    named.in_play = named.in_play || in_play;
    return;
  }
  named_.push_back({touch.robot, touch.time, touch.time, in_play});
}

std::vector<Witness> all_witnesses(const world::Geometry& geometry) {
  std::vector<Witness> all;
  all.emplace_back("accel", geometry, TouchAlgorithms{.accel = true});
  all.emplace_back("accel + line", geometry, TouchAlgorithms{.accel = true, .line = true});
  all.emplace_back("accel + backtrack", geometry, TouchAlgorithms{.accel = true, .backtrack = true});
  all.emplace_back("all three", geometry, TouchAlgorithms{.accel = true, .line = true, .backtrack = true});
  all.emplace_back("all three, as coded", geometry,
                   TouchAlgorithms{.accel = true, .line = true, .backtrack = true, .as_coded = true});
  all.emplace_back("likelihood", geometry, TouchAlgorithms{.likelihood = true});
  all.push_back(Witness::nearest(geometry));
  return all;
}

TouchCount count_touches(const std::deque<TrueTouch>& truth, const Witness& witness, double window) {
  TouchCount count;
  count.witness = witness.name();
  count.window = window;
  const world::Duration slack = world::from_seconds(window);
  std::map<world::RobotId, std::vector<std::size_t>> of_robot;  // sorted by time
  for (std::size_t n = 0; n < truth.size(); ++n) of_robot[truth[n].robot].push_back(n);

  struct Pair {
    world::Duration apart;
    std::size_t named, touch;
  };
  std::vector<Pair> pairs;
  std::vector<bool> near(witness.named().size());
  for (std::size_t n = 0; n < witness.named().size(); ++n) {
    const Witness::Named& named = witness.named()[n];
    const auto robot = of_robot.find(named.robot);
    if (robot == of_robot.end()) continue;
    const auto& touches = robot->second;
    auto it = std::ranges::lower_bound(touches, named.begin - slack, {},
                                       [&](std::size_t touch) { return truth[touch].end; });
    for (; it != touches.end() && truth[*it].begin <= named.end + slack; ++it) {
      const TrueTouch& touch = truth[*it];
      const world::Duration apart =
          std::max({touch.begin - named.end, named.begin - touch.end, world::Duration{}});
      pairs.push_back({apart, n, *it});
      near[n] = true;
    }
  }
  std::ranges::stable_sort(pairs, {}, &Pair::apart);
  std::vector<bool> named_used(witness.named().size());
  std::vector<bool> found(truth.size());
  for (const Pair& pair : pairs) {
    const bool overlap = pair.apart == world::Duration{};
    if (found[pair.touch] || (named_used[pair.named] && !overlap)) continue;
    named_used[pair.named] = found[pair.touch] = true;
  }
  std::vector<bool> stands(witness.named().size());
  std::vector<bool> has_own(truth.size());
  for (const Pair& pair : pairs) {
    if (has_own[pair.touch] || stands[pair.named]) continue;
    stands[pair.named] = has_own[pair.touch] = true;
    count.own += truth[pair.touch].in_play;
  }
  for (std::size_t n = 0; n < truth.size(); ++n) {
    if (!truth[n].in_play) continue;
    ++(found[n] ? count.found : count.missed)[static_cast<std::size_t>(truth[n].kind())];
  }
  for (std::size_t n = 0; n < named_used.size(); ++n) {
    if (!witness.named()[n].in_play || named_used[n]) continue;
    ++(near[n] ? count.again : count.extra);
  }
  return count;
}

}  // namespace judge

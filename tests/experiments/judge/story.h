#pragma once

#include <vector>

#include "experiments/judge/laws/laws.h"

namespace judge {

inline constexpr world::RobotId yellow(int number) {
  return {world::Team::Yellow, static_cast<std::uint8_t>(number)};
}
inline constexpr world::RobotId blue(int number) {
  return {world::Team::Blue, static_cast<std::uint8_t>(number)};
}

/// Truth written by hand: what is set stays until it is changed; every `tick` is one frame for the laws. Blue
/// defends +x, both goalies are number 0.
///
/// Mirrored, everything happens at the other end: places and velocities turned by half a turn, the goals too.
class Story {
 public:
  explicit Story(bool mirrored = false, const world::RuleSet& rules = world::rule_set("ssl-2015"))
      : laws_(rules, Bands{}), sign_(mirrored ? -1 : 1) {
    state.location = world::Location::GameOn;
    state.blue_on_positive_half = !mirrored;
    ball.position = {0, 0, radius};
    tick();  // the first moment
  }

  static constexpr double radius = 0.0215;  // [m]

  world::GameState state;
  truth::Ball ball;
  std::vector<truth::Robot> robots;

  truth::Robot& robot(world::RobotId id, world::Vector2d position = world::Vector2d::Zero(),
                      world::Vector2d velocity = world::Vector2d::Zero()) {
    for (truth::Robot& one : robots) {
      if (one.id == id) return one;
    }
    truth::Robot fresh;
    fresh.id = id;
    fresh.position = position;
    fresh.velocity = velocity;
    robots.push_back(fresh);
    std::ranges::sort(robots, {}, &truth::Robot::id);
    return robot(id);
  }

  /// In the next tick that robot touches the ball, `substep` 1 to 4.
  void touch(world::RobotId id, double impulse = 0.01, int substep = 4) {
    contacts_.push_back({world::tick_time(tick_, substep), id, at(ball.position), impulse});
  }

  void enter(world::Location location) {
    state.location = location;
    state.location_time = world::tick_time(tick_);
    state.command_time = state.location_time;
    ++state.command_counter;
  }

  /// `count` ticks in which everything moves on with its velocity.
  void tick(int count = 1) {
    for (; count > 0; --count) {
      ball.position += ball.velocity * world::tick_length;
      for (truth::Robot& one : robots) one.position += one.velocity * world::tick_length;
      truth::Frame frame;
      frame.tick = ++tick_;
      frame.time = world::tick_time(tick_);
      frame.ball = ball;
      frame.ball.position = at(ball.position);
      frame.ball.velocity = at(ball.velocity);
      frame.robots = robots;
      for (truth::Robot& one : frame.robots) {
        one.position *= sign_;
        one.velocity *= sign_;
        if (sign_ < 0) one.orientation += 3.14159265358979323846;
      }
      frame.contacts = std::move(contacts_);
      contacts_.clear();
      state.time = frame.time;
      laws_.watch(frame, state, true);
    }
  }

  /// The game is over.
  void end() { laws_.finish(); }

  double now() const { return world::seconds(world::tick_time(tick_)); }
  const Laws& laws() const { return laws_; }

  /// What was told of an event so far, near misses too.
  std::vector<TrueEvent> told(Event event) const {
    std::vector<TrueEvent> found;
    for (const TrueEvent& one : laws_.events()) {
      if (one.event == event) found.push_back(one);
    }
    return found;
  }

 private:
  world::Vector3d at(const world::Vector3d& vector) const {
    return {sign_ * vector.x(), sign_ * vector.y(), vector.z()};
  }

  Laws laws_;
  double sign_;
  std::int64_t tick_ = 0;
  std::vector<truth::Contact> contacts_;
};

}  // namespace judge

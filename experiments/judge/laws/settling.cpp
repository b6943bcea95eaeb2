#include "experiments/judge/laws/settling.h"

namespace judge {
namespace {

// What the filter may be wrong by: ours.
constexpr double ball_speed_band = 0.05;  // [m/s]
constexpr double robot_speed_band = 0.1;  // [m/s]
constexpr double place_band = 0.02;       // [m] twice a camera's offset
constexpr std::size_t stretch = 6;        // ticks
constexpr world::Duration agreed = std::chrono::milliseconds{300};

}  // namespace

bool Settling::ready(const Moment& moment, int wider) const {
  if (!moment.state.is_kickoff) return true;
  return std::ranges::all_of(moment.now.robots, [&](const truth::Robot& robot) {
    const double own = world::sign(world::defended_side(moment.state, robot.id.team));
    return robot.position.x() * own >= -wider * moment.bands.length;
  });
}

bool Settling::steady(const Moment& moment, int wider) const {
  const world::RuleSet& rules = moment.rules;
  if (moment.by_hand) return false;
  if (ball_speed_ > rules.ball_settled_speed + wider * ball_speed_band) return false;
  if (robot_speed_ > rules.robot_settled_speed + wider * robot_speed_band) return false;
  const auto& place = moment.state.reset_position;
  if (place && (moment.ball() - *place).norm() > rules.placement_tolerance + wider * place_band) return false;
  return ready(moment, wider);
}

void Settling::measure(const Moment& moment) {
  if (moment.by_hand) past_.clear();
  past_.push_back(moment.now);
  if (past_.size() > stretch + 1) past_.pop_front();
  const truth::Frame& then = past_.front();
  const double time = std::max(world::seconds(moment.now.time - then.time), world::tick_length);
  const auto speed = [&](const world::Vector2d& from, const world::Vector2d& to, const world::Vector2d& now) {
    return std::min((to - from).norm() / time, now.norm());
  };
  ball_speed_ = speed(then.ball.position.head<2>(), moment.ball(), moment.now.ball.velocity.head<2>());
  robot_speed_ = 0;
  for (const truth::Robot& robot : moment.now.robots) {
    const truth::Robot* before = find_robot(then, robot.id);
    if (before == nullptr) continue;
    robot_speed_ = std::max(robot_speed_, speed(before->position, robot.position, robot.velocity));
  }
}

void Settling::watch(const Moment& moment, std::vector<TrueEvent>& out) {
  const bool off = moment.in(world::Location::GameOff);
  const bool anew = off && (moment.entered || moment.state.command_counter != counter_ || !waiting_);
  if (waiting_ && anew) {
    // The next command was given a moment ago: what was about to be settled counts.
    for (Wait& wait : waits_) {
      const world::Duration limit = moment.rules.settle_limit * (ready(moment, 0) ? 1 : 2);
      const bool nearly = moment.now.time - wait.begin >= limit - agreed;
      if (!wait.settled && nearly) wait.settled = moment.now.time;
    }
    finish(out);
  }
  if (anew) {
    waiting_ = true;
    counter_ = moment.state.command_counter;
    left_.reset();
    // Waiting begins where the state began, which is known a few ticks later.
    for (Wait& wait : waits_) wait = {moment.now.time, moment.now.time, std::nullopt};
  }
  if (!waiting_) {
    past_.clear();
    return;
  }
  measure(moment);
  if (!off && !left_) left_ = moment.now.time;
  if (left_ && moment.now.time > *left_ + agreed) {
    finish(out);
    return;
  }
  for (int n = 0; n < 3; ++n) {
    Wait& wait = waits_[static_cast<std::size_t>(n)];
    if (wait.settled) continue;
    if (!steady(moment, n - 1)) wait.steady = moment.now.time;
    const world::Duration limit = moment.rules.settle_limit * (ready(moment, n - 1) ? 1 : 2);
    if (moment.now.time - wait.steady >= moment.rules.settled_for || moment.now.time - wait.begin >= limit) {
      wait.settled = moment.now.time;
    }
  }
}

void Settling::finish(std::vector<TrueEvent>& out) {
  waiting_ = false;
  const auto& [narrow, as_is, wide] = waits_;
  if (!wide.settled) return;
  const bool clear = narrow.settled && *narrow.settled - *wide.settled <= agreed;
  TrueEvent event;
  event.event = Event::RobotsSettled;
  event.time = clear ? as_is.settled.value_or(*wide.settled) : *wide.settled;
  // Where the bands disagree, anything from the first of them on is right.
  event.until = narrow.settled.value_or(left_.value_or(event.time));
  event.margin = clear ? near_bands : as_is.settled ? 0.5 : -0.5;
  out.push_back(event);
}

}  // namespace judge

#include "experiments/statistics/observer.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace statistics {
namespace {

// Definitions of the header, in numbers. Ours, where no source is named.
constexpr double least_impulse = 1e-3;  // [N s]
constexpr world::Duration same_touch = std::chrono::milliseconds{50};
constexpr double beside_the_posts = 0.3;  // [m]
constexpr double beside_a_mate = 0.5;     // [m]
constexpr double nearest_mate = 0.2;      // [m] between centres: nearer is not a pass
constexpr world::Duration held = std::chrono::milliseconds{500};
constexpr double longest_step = 0.2;                                 // [m] in a tick: 12 m/s
constexpr world::Duration leaving = std::chrono::milliseconds{100};  // the kicker's own contacts after a kick
constexpr double gravity = 9.81;                                     // [m/s^2]
constexpr double kept_at_landing = 5.0 / 7;                          // of the speed along the carpet
constexpr double least_rise = 0.05;  // [m/s] upwards: below it the ball stays on the carpet

bool playable(world::Location location) {
  return location == world::Location::GameOn || location == world::Location::Setup;
}

}  // namespace

double FreePath::height(double distance, double ball_radius) const {
  if (distance >= flight || flight <= 0) return ball_radius;
  // A parabola that starts at height0 and lands (centre at the radius) after `flight`.
  const double fall = (height0 - ball_radius + rise * flight) / (flight * flight);
  return height0 + rise * distance - fall * distance * distance;
}

FreePath free_path(const truth::Kick& kick, const world::Geometry& geometry) {
  FreePath path;
  path.start = kick.position.head<2>();
  path.height0 = kick.position.z();
  double speed = kick.velocity.head<2>().norm();
  if (speed <= 0) return path;
  path.direction = kick.velocity.head<2>() / speed;
  const double up = kick.velocity.z();
  if (up > least_rise) {
    const double above = std::max(0.0, path.height0 - geometry.field.ball_radius);
    const double time = (up + std::sqrt(up * up + 2 * gravity * above)) / gravity;
    path.flight = speed * time;
    path.rise = up / speed;
    speed *= kept_at_landing;
    path.reach = path.flight + speed * speed / (2 * geometry.ball_roll_deceleration);
    return path;
  }
  const double rolling = geometry.ball_switch_ratio * speed;
  path.reach = (speed * speed - rolling * rolling) / (2 * geometry.ball_slide_deceleration) +
               rolling * rolling / (2 * geometry.ball_roll_deceleration);
  return path;
}

Aim aim_of(const FreePath& path, world::Side goal, const world::Geometry& geometry) {
  const world::Field& field = geometry.field;
  const double towards = path.direction.x() * world::sign(goal);
  const double ahead = field.half_length() - path.start.x() * world::sign(goal);
  if (towards <= 0 || ahead < 0) return {};
  const double distance = ahead / towards;
  if (distance > path.reach) return {};
  const double y = std::abs(path.start.y() + path.direction.y() * distance);
  Aim aim;
  aim.shot = y <= field.goal_width / 2 + beside_the_posts;
  aim.on_target = y <= field.goal_width / 2 - field.ball_radius &&
                  path.height(distance, field.ball_radius) <= field.goal_height - field.ball_radius;
  return aim;
}

Observer::Observer(const world::Geometry& geometry) : geometry_(geometry) {
  places_.reserve(2 * (world::max_robot_number + 1));
}

void Observer::update(const truth::Frame& frame, const world::GameState& state) {
  ++ticks_;
  if (state.location != world::Location::GameOn) end_passage();
  if (!playable(state.location)) {
    settle(std::nullopt, state);
    last_touch_.reset();
    owner_.reset();
    challenged_ = false;
  } else {
    // By time; at the same instant the contact comes first, since a kick needs one.
    std::size_t next_kick = 0;
    const auto kicks_before = [&](world::Time time) {
      for (; next_kick < frame.kicks.size() && frame.kicks[next_kick].time < time; ++next_kick)
        kick(frame.kicks[next_kick], frame, state);
    };
    for (const truth::Contact& contact : frame.contacts) {
      kicks_before(contact.time);
      touch(contact, state);
    }
    for (; next_kick < frame.kicks.size(); ++next_kick) kick(frame.kicks[next_kick], frame, state);
    count_time(frame, state);
  }
  run(frame);
}

void Observer::touch(const truth::Contact& contact, const world::GameState& state) {
  if (contact.impulse <= least_impulse) return;
  const bool own_kick =
      open_kick_ && open_kick_->kicker == contact.robot && contact.time - open_kick_->time <= leaving;
  if (open_kick_ && !own_kick) settle(contact.robot, state);
  const bool goes_on =
      last_touch_ && last_touch_->robot == contact.robot && contact.time - last_touch_->time <= same_touch;
  if (!goes_on) ++counted_.teams[contact.robot.team].touches;
  last_touch_ = Touch{contact.robot, contact.time};
}

void Observer::kick(const truth::Kick& kick, const truth::Frame& frame, const world::GameState& state) {
  settle(kick.robot, state);
  ++counted_.teams[kick.robot.team].kicks;
  last_touch_ = Touch{kick.robot, kick.time};
  OpenKick open;
  open.kicker = kick.robot;
  open.time = kick.time;
  const FreePath path = free_path(kick, geometry_);
  open.aim = aim_of(path, world::other(world::defended_side(state, kick.robot.team)), geometry_);
  for (const truth::Robot& robot : frame.robots) {
    if (robot.id.team != kick.robot.team || robot.id == kick.robot) continue;
    const world::Vector2d to = robot.position - path.start;
    const double along = to.dot(path.direction);
    if (along <= 0 || to.norm() < nearest_mate || along > path.reach + beside_a_mate) continue;
    if ((to - along * path.direction).norm() <= beside_a_mate) open.towards_mate = true;
  }
  open_kick_ = open;
}

void Observer::settle(std::optional<world::RobotId> next, const world::GameState& state) {
  if (!open_kick_) return;
  count(*open_kick_, next, state.keeper[world::opponent(open_kick_->kicker.team)]);
  open_kick_.reset();
}

void Observer::count(const OpenKick& kick, std::optional<world::RobotId> next, int keeper) {
  record::TeamStatistics& team = counted_.teams[kick.kicker.team];
  const bool by_team = next && next->team == kick.kicker.team;
  if (by_team && *next != kick.kicker) {
    ++team.passes;
    ++team.passes_completed;
    return;
  }
  if (kick.aim.shot) {
    ++team.shots;
    if (!kick.aim.on_target) return;
    ++team.shots_on_target;
    if (next && !by_team && next->number == keeper) ++counted_.teams[next->team].saves;
    return;
  }
  if (kick.towards_mate && !by_team) ++team.passes;
}

void Observer::count_time(const truth::Frame& frame, const world::GameState& state) {
  if (state.location != world::Location::GameOn) return;
  ++ticks_in_play_;
  ++passage_ticks_;
  if (last_touch_) {
    ++possession_ticks_[last_touch_->robot.team];
    follow_possession(frame.time);
  }
  const double x = frame.ball.position.x();
  if (x != 0) {
    const world::Side side = x > 0 ? world::Side::Positive : world::Side::Negative;
    ++territory_ticks_[world::opponent(world::defending_team(state, side))];
  }
  watch_lines(frame.ball);
}

void Observer::follow_possession(world::Time now) {
  const world::Team last = last_touch_->robot.team;
  if (!owner_) owner_ = last;
  if (last == *owner_) {
    challenged_ = false;
    return;
  }
  if (!challenged_) challenged_since_ = now;
  challenged_ = true;
  if (now - challenged_since_ < held) return;
  ++counted_.teams[*owner_].turnovers;
  owner_ = last;
  challenged_ = false;
}

void Observer::watch_lines(const truth::Ball& ball) {
  if (out_ || !last_touch_) return;
  const world::Field& field = geometry_.field;
  const double x = std::abs(ball.position.x()) - field.half_length() - field.ball_radius;
  const double y = std::abs(ball.position.y()) - field.half_width() - field.ball_radius;
  if (x <= 0 && y <= 0) return;
  out_ = true;
  const bool in_goal =
      x > 0 && std::abs(ball.position.y()) < field.goal_width / 2 && ball.position.z() < field.goal_height;
  if (!in_goal) ++counted_.teams[last_touch_->robot.team].balls_out;
}

void Observer::end_passage() {
  if (passage_ticks_ > 0) ++counted_.passages;
  longest_passage_ticks_ = std::max(longest_passage_ticks_, passage_ticks_);
  passage_ticks_ = 0;
  out_ = false;
}

void Observer::run(const truth::Frame& frame) {
  // Robots are sorted by id and seldom come or go: the places of the last tick are in the same order.
  const bool same =
      places_.size() == frame.robots.size() &&
      std::equal(places_.begin(), places_.end(), frame.robots.begin(),
                 [](const Place& place, const truth::Robot& robot) { return place.robot == robot.id; });
  if (!same) {
    places_.clear();
    for (const truth::Robot& robot : frame.robots) places_.push_back({robot.id, robot.position});
    return;
  }
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const double step = (frame.robots[i].position - places_[i].position).norm();
    if (step <= longest_step) counted_.teams[places_[i].robot.team].distance += step;
    places_[i].position = frame.robots[i].position;
  }
}

void Observer::finish() {
  if (open_kick_) count(*open_kick_, std::nullopt, 0);
  open_kick_.reset();
  end_passage();
}

record::MatchStatistics Observer::result() const {
  record::MatchStatistics result = counted_;
  const auto seconds = [](std::int64_t ticks) {
    return static_cast<double>(ticks) / world::ticks_per_second;
  };
  result.time = seconds(ticks_);
  result.in_play = seconds(ticks_in_play_);
  result.longest_passage = seconds(std::max(longest_passage_ticks_, passage_ticks_));
  if (passage_ticks_ > 0) ++result.passages;
  for (const world::Team team : world::both_teams) {
    result.teams[team].possession = seconds(possession_ticks_[team]);
    result.teams[team].territory = seconds(territory_ticks_[team]);
  }
  return result;
}

}  // namespace statistics

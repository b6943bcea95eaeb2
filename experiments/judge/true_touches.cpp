#include "experiments/judge/true_touches.h"

#include <algorithm>

namespace judge {
namespace {

constexpr double ball_radius = 0.0215;  // [m]
constexpr double kept_speed = 0.5;      // [m/s] slower than this against the robot: it has it
constexpr world::Duration long_contact = std::chrono::milliseconds{150};  // longer is a dribble
constexpr std::size_t remembered = 64;                                    // contacts
constexpr std::array<std::string_view, kinds> kind_names = {"kick", "receive", "deflection", "dribble",
                                                            "squeeze"};

std::size_t slot(world::RobotId id) {
  return (id.team == world::Team::Yellow ? 0U : world::max_robot_number + 1U) + id.number;
}

}  // namespace

std::string_view name(Kind kind) { return kind_names[static_cast<std::size_t>(kind)]; }

std::optional<Kind> kind_named(std::string_view name) {
  const auto it = std::ranges::find(kind_names, name);
  if (it == kind_names.end()) return std::nullopt;
  return static_cast<Kind>(it - kind_names.begin());
}

Kind TrueTouch::kind() const {
  if (squeezed) return Kind::Squeeze;
  if (kicked) return Kind::Kick;
  if (end - begin > long_contact) return Kind::Dribble;
  return speed_after < kept_speed ? Kind::Receive : Kind::Deflection;
}

void TrueTouches::add(const truth::Frame& frame, bool in_play) {
  fresh_.clear();
  for (const truth::Contact& contact : frame.contacts) {
    if (contact.impulse < least_impulse) continue;
    std::optional<std::size_t>& open = open_[slot(contact.robot)];
    if (!open || contact.time - all_[*open].end > apart) {
      open = all_.size();
      TrueTouch& fresh = all_.emplace_back();
      fresh.robot = contact.robot;
      fresh.begin = contact.time;
      fresh.in_play = in_play;
    }
    TrueTouch& touch = all_[*open];
    touch.end = contact.time;
    touch.place = contact.point.head<2>();
    touch.impulse += contact.impulse;
    for (auto it = recent_.rbegin(); it != recent_.rend() && contact.time - it->time <= one_tick; ++it) {
      if (all_[it->touch].robot.team == contact.robot.team) continue;
      all_[it->touch].squeezed = true;
      touch.squeezed = true;
    }
    fresh_.push_back({contact.time, *open, contact.impulse});
    recent_.push_back(fresh_.back());
    if (recent_.size() > remembered) recent_.pop_front();
  }
  for (const truth::Kick& kick : frame.kicks) {
    const auto& open = open_[slot(kick.robot)];
    if (open && frame.time - all_[*open].end < apart) all_[*open].kicked = true;
  }
  const Contact* last = last_at(frame.time);
  if (last == nullptr) return;
  TrueTouch& touch = all_[last->touch];
  touch.highest = std::max(touch.highest, frame.ball.position.z() - ball_radius);
  for (const truth::Robot& robot : frame.robots) {
    if (robot.id != touch.robot || frame.time - touch.end > apart) continue;
    touch.speed_after = (frame.ball.velocity.head<2>() - robot.velocity).norm();
  }
}

const TrueTouches::Contact* TrueTouches::last_at(world::Time time) const {
  const Contact* last = nullptr;
  for (auto it = recent_.rbegin(); it != recent_.rend(); ++it) {
    if (it->time > time) continue;
    if (last != nullptr && it->time != last->time) break;
    if (last == nullptr || it->impulse > last->impulse) last = &*it;
  }
  return last;
}

bool TrueTouches::ambiguous(const Contact& contact) const {
  const world::Team team = all_[contact.touch].robot.team;
  return std::ranges::any_of(recent_, [&](const Contact& other) {
    return all_[other.touch].robot.team != team && other.time <= contact.time &&
           contact.time - other.time <= one_tick;
  });
}

double TrueTouches::alone(const Contact& contact) const {
  const world::Team team = all_[contact.touch].robot.team;
  for (auto it = recent_.rbegin(); it != recent_.rend(); ++it) {
    if (it->time <= contact.time && all_[it->touch].robot.team != team) {
      return world::seconds(contact.time - it->time);
    }
  }
  return 1e9;
}

}  // namespace judge

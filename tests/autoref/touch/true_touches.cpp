#include "tests/autoref/touch/true_touches.h"

#include <algorithm>

#include "sim/world/time.h"

namespace study {
namespace {

constexpr double ball_radius = 0.0215;  // [m]
constexpr double kept_speed = 0.5;      // [m/s] slower than this against the robot: it has it
constexpr world::Duration long_contact = std::chrono::milliseconds{150};  // longer is a dribble
constexpr world::Duration one_tick = std::chrono::microseconds{16'667};

}  // namespace

const char* name(Kind kind) {
  constexpr std::array names = {"kick", "receive", "deflection", "dribble", "squeeze"};
  return names[static_cast<std::size_t>(kind)];
}

Kind TrueTouch::kind() const {
  if (squeezed) return Kind::Squeeze;
  if (kicked) return Kind::Kick;
  if (end - begin > long_contact) return Kind::Dribble;
  return speed_after < kept_speed ? Kind::Receive : Kind::Deflection;
}

void TrueTouches::add(const truth::Frame& frame) {
  double greatest = 0;
  world::Time when{};
  for (const truth::Contact& contact : frame.contacts) {
    if (contact.impulse < least_impulse) continue;
    const int team = contact.robot.team == world::Team::Yellow ? 0 : world::max_robot_number + 1;
    TrueTouch*& touch = open_[static_cast<std::size_t>(team + contact.robot.number)];
    if (!touch || contact.time - touch->end > apart) {
      touch = &all_.emplace_back();
      touch->robot = contact.robot;
      touch->begin = contact.time;
    }
    touch->end = contact.time;
    touch->impulse += contact.impulse;
    const auto other = by_team_[world::opponent(contact.robot.team)];
    if (other && contact.time - *other <= one_tick) touch->squeezed = true;
    by_team_[contact.robot.team] = contact.time;
    if (contact.time > when || contact.impulse > greatest) {
      toucher_ = contact.robot;
      last_ = touch;
      greatest = contact.impulse;
      when = contact.time;
    }
  }
  for (const truth::Kick& kick : frame.kicks) {
    const int team = kick.robot.team == world::Team::Yellow ? 0 : world::max_robot_number + 1;
    TrueTouch* touch = open_[static_cast<std::size_t>(team + kick.robot.number)];
    if (touch && frame.time - touch->end < apart) touch->kicked = true;
  }
  if (!last_) return;
  last_->highest = std::max(last_->highest, frame.ball.position.z() - ball_radius);
  for (const truth::Robot& robot : frame.robots) {
    if (robot.id != last_->robot || frame.time - last_->end > apart) continue;
    last_->speed_after = (frame.ball.velocity.head<2>() - robot.velocity).norm();
  }
}

}  // namespace study

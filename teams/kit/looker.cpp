#include "teams/kit/looker.h"

#include <algorithm>
#include <cmath>

#include "sim/world/geometry.h"

namespace kit {
namespace {

using world::Vector2d;

Robot turned(const world::TrackedRobot& tracked, double flip) {
  Robot robot;
  robot.number = tracked.id.number;
  robot.position = flip * tracked.position;
  robot.orientation = flip < 0 ? world::wrap_angle(tracked.orientation + M_PI) : tracked.orientation;
  robot.velocity = flip * tracked.velocity;
  robot.angular_velocity = tracked.angular_velocity;
  robot.ball_in_reach = tracked.ball_in_reach;
  return robot;
}

// The velocity moves towards what was asked, as fast as the limits allow (the simulator's drive does the
// same).
Vector2d driven(const Vector2d& velocity, Vector2d asked, const world::RobotSpecs& specs, double dt) {
  const double speed = asked.norm();
  if (speed > specs.max_speed) asked *= specs.max_speed / speed;
  const Vector2d change = asked - velocity;
  const double size = change.norm();
  const bool braking = asked.squaredNorm() < velocity.squaredNorm();
  const double most = (braking ? specs.max_brake : specs.max_acceleration) * dt;
  return size <= most ? asked : Vector2d(velocity + change * (most / size));
}

}  // namespace

int Team::keeper(const Setup& setup) const {
  return setup.robots.empty() ? 0 : setup.robots.front().id.number;
}

Looker::Looker(const Setup& setup)
    : setup_(setup), model_(setup.geometry), reader_(setup.team, setup.geometry.field.ball_radius) {
  view_.geometry = setup.geometry;
  view_.own.reserve(16);
  view_.opponents.reserve(16);
}

const View& Looker::look(std::int64_t tick, const world::TrackedFrame& frame,
                         const world::RefereeMessage& message, std::span<const std::uint8_t> contacts) {
  const bool flipped = GameReader::defends_positive(message, setup_.team);
  const double flip = flipped ? -1.0 : 1.0;
  const world::Time takes_effect = world::tick_time(tick + setup_.command_latency);
  const double ahead = std::clamp(world::seconds(takes_effect - frame.time), 0.0, 0.2);

  view_.tick = tick;
  view_.time = world::seconds(world::tick_time(tick));
  view_.own.clear();
  view_.opponents.clear();
  for (const world::TrackedRobot& tracked : frame.robots) {
    Robot robot = turned(tracked, flip);
    if (tracked.id.team != setup_.team) {
      robot.position += robot.velocity * ahead;
      view_.opponents.push_back(robot);
      continue;
    }
    for (const world::RobotSpecs& specs : setup_.robots) {
      if (specs.id.number == robot.number) robot.specs = specs;
    }
    robot.ball_contact = std::find(contacts.begin(), contacts.end(), robot.number) != contacts.end();
    predict_own(robot, frame.time);
    view_.own.push_back(robot);
  }

  watch_ball_speed(frame);
  Ball& ball = view_.ball;
  ball.known = frame.ball.has_value();
  if (frame.ball) {
    ball.position = flip * frame.ball->position.head<2>();
    ball.velocity = flip * frame.ball->velocity.head<2>();
    ball.height = frame.ball->position.z();
    ball.rolls_below = rolls_below_;
    ball.unseen = world::seconds(frame.ball->unseen);
    ball = predicted(ball, model_, ahead);
  } else if (flipped != was_flipped_) {
    ball.position = -ball.position;  // the last place known, seen from the other end
  }
  was_flipped_ = flipped;
  reader_.update(message, view_, view_.game);
  return view_;
}

void Looker::predict_own(Robot& robot, world::Time from) const {
  // Step k runs from tick k-1 to tick k and is driven by reply k-1-latency; reply m acts over ticks m+latency
  // to m+latency+1.
  for (std::int64_t m = view_.tick - static_cast<std::int64_t>(history) + 1; m < view_.tick; ++m) {
    const world::Time start = std::max(world::tick_time(m + setup_.command_latency), from);
    const double dt = world::seconds(world::tick_time(m + setup_.command_latency + 1) - start);
    if (dt <= 0 || m < 0) continue;
    const Sent& sent = sent_[static_cast<std::size_t>(m) % history][robot.number];
    const double turn = sent.angular_velocity - robot.angular_velocity;
    const double most = robot.specs.max_angular_acceleration * dt;
    const double omega = robot.angular_velocity + std::clamp(turn, -most, most);
    const double angle = robot.orientation + 0.5 * omega * dt;
    const Vector2d velocity =
        driven(robot.velocity, world::rotated(sent.velocity_local, angle), robot.specs, dt);
    robot.position += 0.5 * (robot.velocity + velocity) * dt;
    robot.velocity = velocity;
    robot.orientation = world::wrap_angle(robot.orientation + omega * dt);
    robot.angular_velocity = omega;
  }
}

// A kick is a sudden gain of speed, or more speed than the last kick gave: from there the ball slides down to
// the switch ratio of it. 0.3 m/s in a tick is clear of the filter's noise (ours).
void Looker::watch_ball_speed(const world::TrackedFrame& frame) {
  const double speed = frame.ball ? frame.ball->velocity.head<2>().norm() : 0.0;
  const double switches_at = speed * model_.switch_ratio;
  if (speed > speed_before_ + 0.3 || switches_at > rolls_below_) rolls_below_ = switches_at;
  speed_before_ = speed;
}

void Looker::sent(const world::TeamCommands& commands) {
  auto& slot = sent_[static_cast<std::size_t>(view_.tick) % history];
  slot.fill({});
  for (const world::RobotCommand& command : commands) {
    if (command.number > world::max_robot_number) continue;
    slot[command.number] = {command.velocity_local, command.angular_velocity};
  }
}

}  // namespace kit

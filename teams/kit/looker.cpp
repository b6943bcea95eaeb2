#include "teams/kit/looker.h"

#include <algorithm>
#include <cmath>

#include "sim/world/geometry.h"
#include "teams/kit/ball_course.h"

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

// The simulator's drive: the velocity moves towards what was asked as fast as the limits allow. Along and
// across the heading `forward` they bound ellipses.
Vector2d driven(const Vector2d& velocity, Vector2d asked, const Vector2d& forward,
                const world::RobotSpecs& specs, double dt) {
  // Radius of the ellipse with those half axes in a direction.
  const auto radius = [&forward](const Vector2d& direction, double along, double across) {
    if (along == across) return along;
    const double a = forward.dot(direction) / along;
    const double b = (forward.x() * direction.y() - forward.y() * direction.x()) / across;
    return 1 / std::sqrt(a * a + b * b);
  };
  const double slowest = std::min(specs.max_speed, specs.max_speed_sideways);
  if (asked.squaredNorm() > slowest * slowest) {
    const double speed = asked.norm();
    const double fastest = radius(asked / speed, specs.max_speed, specs.max_speed_sideways);
    if (speed > fastest) asked *= fastest / speed;
  }
  const Vector2d change = asked - velocity;
  // What is possible in every direction, as most changes are, needs no more thought.
  const double always = dt * std::min({specs.max_acceleration, specs.max_acceleration_sideways,
                                       specs.max_brake, specs.max_brake_sideways});
  if (change.squaredNorm() <= always * always) return asked;
  const double size = change.norm();
  if (size < 1e-9) return asked;
  const Vector2d towards = change / size;
  double most = radius(towards, specs.max_acceleration, specs.max_acceleration_sideways);
  const double now = velocity.norm();
  const double along = now > 1e-3 ? towards.dot(velocity) / now : 1;
  if (along < 0) {
    // Slowing down: the brake's share of the direction, the acceleration's across it.
    const double brake = radius(towards, specs.max_brake, specs.max_brake_sideways);
    most = 1 / std::sqrt(along * along / (brake * brake) + (1 - along * along) / (most * most));
  }
  return size <= most * dt ? asked : Vector2d(velocity + towards * (most * dt));
}

// Likewise about the vertical.
double turned_to(double now, double asked, const world::RobotSpecs& specs, double dt) {
  asked = std::clamp(asked, -specs.max_angular_speed, specs.max_angular_speed);
  const double change = asked - now;
  const bool slows = change * now < 0;
  const double most = (slows ? specs.max_angular_brake : specs.max_angular_acceleration) * dt;
  return now + std::clamp(change, -most, most);
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

  Ball& ball = view_.ball;
  ball.known = frame.ball.has_value();
  if (frame.ball) {
    ball.position = flip * frame.ball->position.head<2>();
    ball.velocity = flip * steadied(frame.ball->velocity.head<2>());
    watch_ball_speed(frame);
    ball.height = frame.ball->position.z();
    ball.rolls_below = rolls_below_;
    ball.climb = 0;
    ball.flies = ball.bounced = false;
    if (const std::optional<world::Flight>& flight = frame.ball->flight) {
      ball.flies = true;
      ball.climb = frame.ball->velocity.z();
      // It first lands after 2 v_z / g.
      ball.bounced = world::seconds(frame.time - flight->kicked) > 2 * flight->launch_velocity.z() / 9.81;
    }
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
    const double omega = turned_to(robot.angular_velocity, sent.angular_velocity, robot.specs, dt);
    const double angle = robot.orientation + 0.5 * omega * dt;
    const Vector2d forward = world::direction(angle);
    const Vector2d& local = sent.velocity_local;
    const Vector2d asked(forward.x() * local.x() - forward.y() * local.y(),
                         forward.y() * local.x() + forward.x() * local.y());
    const Vector2d velocity = driven(robot.velocity, asked, forward, robot.specs, dt);
    robot.position += 0.5 * (robot.velocity + velocity) * dt;
    robot.velocity = velocity;
    robot.orientation = world::wrap_angle(robot.orientation + omega * dt);
    robot.angular_velocity = omega;
  }
}

// Between two cameras' views the filter's ball shifts by their bias, a centimetre or two, which looks like
// 0.3 m/s across its way for some frames. So the direction follows with 0.3 of the change in a tick, unless
// something happened to the ball: 0.4 rad or 0.8 m/s in a tick (ours, tests Receive).
Vector2d Looker::steadied(const Vector2d& velocity) {
  const double speed = velocity.norm();
  const double angle = world::angle_of(velocity);
  const double turn = world::wrap_angle(angle - ball_direction_);
  if (speed < 0.5 || std::abs(turn) > 0.4 || std::abs(speed - speed_before_) > 0.8) {
    ball_direction_ = angle;
    return velocity;
  }
  ball_direction_ = world::wrap_angle(ball_direction_ + 0.3 * turn);
  return speed * world::direction(ball_direction_);
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

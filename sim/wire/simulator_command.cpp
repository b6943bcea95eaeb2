#include "sim/wire/simulator_command.h"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "sim/wire/robot_control.h"

namespace wire {

namespace {

constexpr double farthest = 100;       // [m] ours: no field is longer
constexpr double highest_ball = 5;     // [m] from there the ball reaches the ground at 9.9 m/s
constexpr double fastest = 10;         // [m/s] tests/sim/physics: nothing tunnels up to here
constexpr double fastest_turn = 100;   // [rad/s] ours: five times what a robot of the league does
constexpr double largest_angle = 1e3;  // [rad] ours: any angle is meant modulo a turn, this is not meant

/// Takes over numbers of one message and notes the first that cannot be meant.
class Reader {
 public:
  explicit Reader(std::string owner) : owner_(std::move(owner)) {}

  void number(const char* name, bool present, float value, double lowest, double highest,
              std::optional<double>& result) {
    if (!present) return;
    if (value >= lowest && value <= highest) {  // not so for NaN
      result = value;
    } else if (!problem_) {
      problem_ = Problem{code::value, fmt::format("{}: {} = {} must be from {} to {}", owner_, name, value,
                                                  lowest, highest)};
    }
  }
  void speed(const char* name, bool present, float value, std::optional<double>& result) {
    number(name, present, value, -fastest, fastest, result);
  }
  template <class T>
  Result<T> finish(T result) {
    if (problem_) return std::move(*problem_);
    return result;
  }

 private:
  std::string owner_;
  std::optional<Problem> problem_;
};

}  // namespace

Result<BallTeleport> decode(const matchday::simulation::TeleportBall& message) {
  BallTeleport ball;
  Reader reader("teleport_ball");
  reader.number("x", message.has_x(), message.x(), -farthest, farthest, ball.position[0]);
  reader.number("y", message.has_y(), message.y(), -farthest, farthest, ball.position[1]);
  reader.number("z", message.has_z(), message.z(), 0, highest_ball, ball.position[2]);
  reader.speed("vx", message.has_vx(), message.vx(), ball.velocity[0]);
  reader.speed("vy", message.has_vy(), message.vy(), ball.velocity[1]);
  reader.speed("vz", message.has_vz(), message.vz(), ball.velocity[2]);
  ball.safely = message.teleport_safely();
  ball.roll = message.roll();
  ball.by_force = message.by_force();
  return reader.finish(ball);
}

Result<RobotTeleport> decode(const matchday::simulation::TeleportRobot& message) {
  const std::optional<world::RobotId> id = decode(message.id());
  if (!id) {
    return not_a_robot("teleport_robot", message.id());
  }
  RobotTeleport robot;
  robot.id = *id;
  Reader reader(fmt::format("teleport_robot, {} {}", name(id->team), id->number));
  reader.number("x", message.has_x(), message.x(), -farthest, farthest, robot.position[0]);
  reader.number("y", message.has_y(), message.y(), -farthest, farthest, robot.position[1]);
  reader.number("orientation", message.has_orientation(), message.orientation(), -largest_angle,
                largest_angle, robot.orientation);
  std::optional<double> vx;
  std::optional<double> vy;
  std::optional<double> turn;
  reader.speed("v_x", message.has_v_x(), message.v_x(), vx);
  reader.speed("v_y", message.has_v_y(), message.v_y(), vy);
  reader.number("v_angular", message.has_v_angular(), message.v_angular(), -fastest_turn, fastest_turn, turn);
  robot.velocity = {vx.value_or(0), vy.value_or(0)};
  robot.angular_velocity = turn.value_or(0);
  robot.says_how_fast = vx || vy || turn;
  if (message.has_present()) robot.present = message.present();
  robot.by_force = message.by_force();
  return reader.finish(robot);
}

}  // namespace wire

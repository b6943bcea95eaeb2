#include "sim/server/simulation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/engine/line_up.h"
#include "sim/server/wheels.h"

namespace server {
namespace {

using wire::Problem;
namespace code = wire::code;

constexpr double safe_clearance = 0.15;  // [m] from the ball's centre to a hull, as the match host keeps
constexpr double fastest_ball = 10;      // [m/s] tests/sim/physics: nothing tunnels up to here

// The walls are the outer edge of the run-off.
world::Vector2d wall(const world::Field& field) {
  return {field.half_length() + field.boundary_width, field.half_width() + field.boundary_width};
}

void remove_all(engine::Engine& engine) {
  for (const world::Team team : world::both_teams) {
    for (const world::RobotSpecs& specs : engine.model().robots[team]) engine.remove_robot(specs.id);
  }
}

}  // namespace

Simulation::Simulation(const Setup& setup, const world::PerTeam<std::vector<int>>& robots)
    : setup_(setup), engine_((check(setup), model(setup))) {
  remove_all(engine_);
  for (const world::Team team : world::both_teams) {
    const world::Side side = team == world::Team::Blue ? world::Side::Positive : world::Side::Negative;
    const auto poses = engine::line_up(setup.field, side, robots[team].size());
    for (std::size_t i = 0; i < poses.size(); ++i) {
      engine_.put_robot({team, static_cast<std::uint8_t>(robots[team][i])}, poses[i].position,
                        poses[i].orientation);
    }
  }
}

void Simulation::reconfigure(const Setup& setup) {
  check(setup);
  if (same_world(setup, setup_)) {  // some clients repeat themselves
    setup_ = setup;
    return;
  }
  engine::Engine fresh(model(setup));
  const truth::Frame before = engine_.truth();
  first_tick_ = tick();
  setup_ = setup;
  engine_ = std::move(fresh);
  remove_all(engine_);
  for (const truth::Robot& robot : before.robots) {
    const double radius = setup_.specs[robot.id.team][robot.id.number].radius;
    engine_.put_robot(robot.id, inside(robot.position, radius), robot.orientation, robot.velocity,
                      robot.angular_velocity);
  }
  truth::Ball ball = before.ball;
  const double radius = setup_.field.ball_radius;
  ball.position.head<2>() = inside(ball.position.head<2>(), radius);
  ball.position.z() = std::max(ball.position.z(), radius);
  engine_.put_ball(ball);
  detections_.clear();
}

world::Vector2d Simulation::inside(const world::Vector2d& position, double radius) const {
  const world::Vector2d limit = wall(setup_.field) - world::Vector2d(radius, radius);
  return position.cwiseMax(-limit).cwiseMin(limit);
}

std::optional<Problem> Simulation::outside_walls(const char* what, const world::Vector2d& position,
                                                 double radius) const {
  if (inside(position, radius) == position) return std::nullopt;
  const world::Vector2d limit = wall(setup_.field) - world::Vector2d(radius, radius);
  return Problem{code::value,
                 fmt::format("{}: ({:.3f}, {:.3f}) is outside the walls; x may be up to +-{:.3f} "
                             "and y up to +-{:.3f} m",
                             what, position.x(), position.y(), limit.x(), limit.y())};
}

const truth::Robot* Simulation::find(world::RobotId id) const {
  const auto& robots = engine_.truth().robots;
  const auto found = std::find_if(robots.begin(), robots.end(), [&](const auto& r) { return r.id == id; });
  return found == robots.end() ? nullptr : &*found;
}

std::optional<Problem> Simulation::teleport(const wire::BallTeleport& wish) {
  const double radius = setup_.field.ball_radius;
  truth::Ball ball = engine_.truth().ball;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto axis = static_cast<Eigen::Index>(i);
    if (wish.position[i]) ball.position[axis] = *wish.position[i] + (i == 2 ? radius : 0.0);
    if (wish.velocity[i]) ball.velocity[axis] = *wish.velocity[i];
  }
  if (wish.position[0] || wish.position[1]) {
    if (auto problem = outside_walls("teleport_ball", ball.position.head<2>(), radius)) return problem;
  }
  if (!wish.by_force && wish.says_how_fast() && ball.velocity.norm() > fastest_ball) {
    return Problem{code::value, fmt::format("teleport_ball: a speed of {:.2f} m/s; at most {} are possible",
                                            ball.velocity.norm(), fastest_ball)};
  }
  if (wish.safely) engine_.push_robots_out(ball.position.head<2>(), safe_clearance);
  ball_pull_.reset();
  if (wish.by_force) {
    ball_pull_ = ball.position;
  } else if (wish.says_where() || wish.says_how_fast() || wish.roll) {
    if (wish.roll) {
      ball.spin = rolling_spin(ball.velocity, radius);
    } else if (wish.says_how_fast()) {
      ball.spin.setZero();
    }
    engine_.put_ball(ball);
  }
  return std::nullopt;
}

std::optional<Problem> Simulation::teleport(const wire::RobotTeleport& wish) {
  const world::RobotId id = wish.id;
  const std::string owner = fmt::format("teleport_robot, {} {}", name(id.team), id.number);
  const truth::Robot* robot = find(id);
  if (wish.present == false) {
    engine_.remove_robot(id);
    robot_pulls_.erase(id);
    orders_[id.team][id.number].last_tick = -1;
    return std::nullopt;
  }
  if (!robot && !wish.present) {
    return Problem{code::robot_absent, owner + ": is not on the field; say present = true, x and y"};
  }
  if (!robot && !(wish.position[0] && wish.position[1])) {
    return Problem{code::no_place, owner + ": a new robot needs x and y"};
  }
  RobotPull place{robot ? robot->position : world::Vector2d::Zero(), robot ? robot->orientation : 0.0};
  if (wish.position[0]) place.position.x() = *wish.position[0];
  if (wish.position[1]) place.position.y() = *wish.position[1];
  if (wish.orientation) place.orientation = world::wrap_angle(*wish.orientation);
  if (wish.position[0] || wish.position[1]) {
    const double radius = setup_.specs[id.team][id.number].radius;
    if (auto problem = outside_walls(owner.c_str(), place.position, radius)) return problem;
  }
  robot_pulls_.erase(id);
  if (wish.by_force && robot) {
    robot_pulls_[id] = place;
  } else if (!robot || wish.says_where() || wish.says_how_fast) {
    engine_.put_robot(id, place.position, place.orientation, wish.velocity, wish.angular_velocity);
  }
  return std::nullopt;
}

std::optional<Problem> Simulation::order(world::Team team, const wire::RobotOrder& order) {
  const std::uint8_t number = order.command.number;
  if (!find({team, number})) {
    return Problem{code::robot_absent, fmt::format("{} {} is not on the field", name(team), number)};
  }
  orders_[team][number] = {order, tick() + command_life - 1};
  return std::nullopt;
}

world::RobotCommand Simulation::command(const wire::RobotOrder& order, const truth::Robot& robot) const {
  world::RobotCommand command = order.command;
  if (const auto* global = std::get_if<wire::GlobalVelocity>(&order.move)) {
    // A robot turns the wish into its own frame itself, so it counts where it will look in the middle of the
    // tick that this command drives.
    const double wait = (setup_.realism.radio.latency + 0.5) * world::tick_length;
    const double heading = robot.orientation + robot.angular_velocity * wait;
    command.velocity_local = world::rotated(global->velocity, -heading);
    command.angular_velocity = global->angular_velocity;
  } else if (const auto* wheels = std::get_if<wire::WheelSpeeds>(&order.move)) {
    const world::RobotId id = robot.id;
    const auto local =
        motion(setup_.wheels[id.team][id.number], *wheels, setup_.specs[id.team][id.number].radius);
    command.velocity_local = local->velocity;  // `check` has seen that these angles have an answer
    command.angular_velocity = local->angular_velocity;
  }
  return command;
}

void Simulation::drag() {
  if (ball_pull_) engine_.put_ball(pulled(engine_.truth().ball, *ball_pull_, setup_.field.ball_radius));
  for (const auto& [id, place] : robot_pulls_) {
    const truth::Robot moved = pulled(*find(id), place);
    engine_.put_robot(id, moved.position, moved.orientation, moved.velocity, moved.angular_velocity);
  }
}

void Simulation::step() {
  drag();
  world::PerTeam<world::TeamCommands> commands;
  for (const truth::Robot& robot : engine_.truth().robots) {
    const HeldOrder& held = orders_[robot.id.team][robot.id.number];
    world::RobotCommand now;
    now.number = robot.id.number;
    if (held.last_tick >= tick()) now = command(held.order, robot);
    if (robot_pulls_.contains(robot.id)) {  // its own drive goes along with what drags it
      now.velocity_local = world::rotated(robot.velocity, -robot.orientation);
      now.angular_velocity = robot.angular_velocity;
    }
    commands[robot.id.team].push_back(now);
  }
  engine_.step(commands);
  collect_detections();
}

void Simulation::collect_detections() {
  const auto delivered = engine_.detections();
  detections_.resize(delivered.size());
  const world::Duration start = world::tick_time(first_tick_).time_since_epoch();
  for (std::size_t i = 0; i < delivered.size(); ++i) {
    world::Detection& detection = detections_[i];
    detection = delivered[i];
    detection.t_capture = world::whole_microseconds(detection.t_capture + start);
    detection.t_sent = world::whole_microseconds(detection.t_sent + start);
    detection.frame_number = next_frame_[detection.camera]++;
  }
}

}  // namespace server

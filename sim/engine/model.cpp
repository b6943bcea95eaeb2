#include "sim/engine/model.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace engine {
namespace {

constexpr double largest_speed_factor = 10;

void require(bool holds, const std::string& sentence) {
  if (!holds) throw std::invalid_argument(sentence);
}

void check_positive(const std::string& owner, const char* name, double value) {
  require(std::isfinite(value) && value > 0,
          owner + ": " + name + " must be positive, is " + std::to_string(value));
}

void check_field(const world::Field& field) {
  const std::string owner = "field";
  check_positive(owner, "length", field.length);
  check_positive(owner, "width", field.width);
  check_positive(owner, "boundary_width", field.boundary_width);
  check_positive(owner, "goal_width", field.goal_width);
  check_positive(owner, "goal_depth", field.goal_depth);
  check_positive(owner, "goal_height", field.goal_height);
  check_positive(owner, "ball_radius", field.ball_radius);
  require(field.length <= 50 && field.width <= 50, "field: length and width must be at most 50 m, are " +
                                                       std::to_string(field.length) + " and " +
                                                       std::to_string(field.width));
  require(field.goal_width < field.width, "field: goal_width must be smaller than width");
  require(field.boundary_width > field.goal_depth + 0.1,
          "field: boundary_width must leave 0.1 m behind a goal of depth " +
              std::to_string(field.goal_depth) + ", is " + std::to_string(field.boundary_width));
}

void check_robot(const world::RobotSpecs& specs, const std::string& owner) {
  check_positive(owner, "radius", specs.radius);
  check_positive(owner, "height", specs.height);
  check_positive(owner, "mass", specs.mass);
  check_positive(owner, "center_to_dribbler", specs.center_to_dribbler);
  check_positive(owner, "dribbler_width", specs.dribbler_width);
  check_positive(owner, "max_speed", specs.max_speed);
  check_positive(owner, "max_speed_sideways", specs.max_speed_sideways);
  check_positive(owner, "max_acceleration", specs.max_acceleration);
  check_positive(owner, "max_acceleration_sideways", specs.max_acceleration_sideways);
  check_positive(owner, "max_brake", specs.max_brake);
  check_positive(owner, "max_brake_sideways", specs.max_brake_sideways);
  check_positive(owner, "max_angular_speed", specs.max_angular_speed);
  check_positive(owner, "max_angular_acceleration", specs.max_angular_acceleration);
  check_positive(owner, "max_angular_brake", specs.max_angular_brake);
  check_positive(owner, "max_kick_speed", specs.max_kick_speed);
  check_positive(owner, "max_chip_speed", specs.max_chip_speed);
  require(specs.center_to_dribbler < specs.radius,
          owner + ": center_to_dribbler must be smaller than radius");
  // What the walls are proven to hold (tests/sim/physics).
  require(specs.max_kick_speed <= 10,
          owner + ": max_kick_speed must be at most 10 m/s, is " + std::to_string(specs.max_kick_speed));
  require(specs.max_chip_speed <= 7,
          owner + ": max_chip_speed must be at most 7 m/s, is " + std::to_string(specs.max_chip_speed));
  require(specs.max_speed <= 10,
          owner + ": max_speed must be at most 10 m/s, is " + std::to_string(specs.max_speed));
  require(specs.max_speed_sideways <= 10, owner + ": max_speed_sideways must be at most 10 m/s, is " +
                                              std::to_string(specs.max_speed_sideways));
}

}  // namespace

std::vector<world::RobotSpecs> standard_robots(world::Team team, const std::vector<int>& numbers,
                                               double speed_factor, const world::RobotSpecs& body) {
  require(std::isfinite(speed_factor) && speed_factor > 0 && speed_factor <= largest_speed_factor,
          std::string(name(team)) + ": speed_factor must be above 0 and at most 10, is " +
              std::to_string(speed_factor));
  std::vector<world::RobotSpecs> robots;
  for (const int number : numbers) {
    require(number >= 0 && number <= world::max_robot_number,
            std::string(name(team)) + ": robot number must be 0 to 15, is " + std::to_string(number));
    world::RobotSpecs specs = body;
    specs.id = {team, static_cast<std::uint8_t>(number)};
    robots.push_back(world::slowed(specs, speed_factor));
  }
  return robots;
}

void check(const Model& model) {
  check_field(model.geometry.field);
  for (const world::Team team : world::both_teams) {
    const std::vector<world::RobotSpecs>& robots = model.robots[team];
    const std::string team_name = name(team);
    require(robots.size() <= world::max_robot_number + 1,
            team_name + ": at most 16 robots, there are " + std::to_string(robots.size()));
    std::vector<bool> used(world::max_robot_number + 1, false);
    for (const world::RobotSpecs& specs : robots) {
      const std::string owner = team_name + " robot " + std::to_string(specs.id.number);
      require(specs.id.team == team, owner + ": its id says " + name(specs.id.team));
      require(specs.id.number <= world::max_robot_number, owner + ": number must be 0 to 15");
      require(!used[specs.id.number], owner + " is there twice");
      used[specs.id.number] = true;
      check_robot(specs, owner);
    }
  }
  for (const RealismKey& key : realism_keys()) {
    Realism checked = model.realism;
    set(checked, key.name, key.get(model.realism));
  }
}

}  // namespace engine

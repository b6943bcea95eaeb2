#pragma once

#include <gmock/gmock.h>

#include <string>
#include <vector>

#include "sim/engine/realism.h"
#include "sim/proto/simulation.pb.h"
#include "sim/proto/vision.pb.h"
#include "sim/server/server.h"
#include "tests/sim/wire/league_schema.h"

namespace bench {

namespace proto = matchday::simulation;
using world::Team;

inline const std::string protocol = "ssl-simulation-protocol HEAD";

inline proto::Team colour(Team team) { return team == Team::Yellow ? proto::YELLOW : proto::BLUE; }

/// A server without sockets; robots 0 and 1 of each team, nothing random.
struct Bench {
  explicit Bench(const char* realism = "none")
      : server(server::make_setup(world::Field{}, engine::realism(realism), 1),
               {.yellow = {0, 1}, .blue = {0, 1}}, 1, 10020, {}) {}

  proto::SimulatorResponse control(const proto::SimulatorCommand& command) {
    proto::SimulatorResponse response;
    EXPECT_TRUE(response.ParseFromString(server.handle_control(command.SerializeAsString())));
    EXPECT_TRUE(league::missing_required(response, protocol).empty());
    return response;
  }
  /// The codes of the errors, each followed by a space.
  std::string codes(const proto::SimulatorCommand& command) {
    std::string result;
    const proto::SimulatorResponse response = control(command);
    for (const auto& error : response.errors()) {
      EXPECT_FALSE(error.message().empty());
      result += error.code() + " ";
    }
    return result;
  }
  proto::RobotControlResponse robots(Team team, const proto::RobotControl& message) {
    proto::RobotControlResponse response;
    EXPECT_TRUE(response.ParseFromString(server.handle_robots(team, message.SerializeAsString())));
    EXPECT_TRUE(league::missing_required(response, protocol).empty());
    return response;
  }
  void put(Team team, unsigned number, double x, double y, double orientation = 0) {
    proto::SimulatorCommand command;
    auto& robot = *command.mutable_control()->add_teleport_robot();
    robot.mutable_id()->set_id(number);
    robot.mutable_id()->set_team(colour(team));
    robot.set_x(static_cast<float>(x));
    robot.set_y(static_cast<float>(y));
    robot.set_orientation(static_cast<float>(orientation));
    robot.set_present(true);
    EXPECT_EQ(codes(command), "");
  }
  void put_ball(double x, double y) {
    proto::SimulatorCommand command;
    command.mutable_control()->mutable_teleport_ball()->set_x(static_cast<float>(x));
    command.mutable_control()->mutable_teleport_ball()->set_y(static_cast<float>(y));
    EXPECT_EQ(codes(command), "");
  }
  void steps(int count) {
    for (int i = 0; i < count; ++i) server.step();
  }
  const truth::Ball& ball() const { return server.simulation().truth().ball; }
  const truth::Robot* robot(Team team, unsigned number) const {
    for (const truth::Robot& robot : server.simulation().truth().robots) {
      if (robot.id.team == team && robot.id.number == number) return &robot;
    }
    return nullptr;
  }

  server::Server server;
};

/// A message for one robot of a team.
inline proto::RobotControl order(unsigned number) {
  proto::RobotControl message;
  message.add_robot_commands()->set_id(number);
  return message;
}
inline proto::RobotControl local(unsigned number, float forward, float left = 0, float angular = 0) {
  proto::RobotControl message = order(number);
  auto& velocity = *message.mutable_robot_commands(0)->mutable_move_command()->mutable_local_velocity();
  velocity.set_forward(forward);
  velocity.set_left(left);
  velocity.set_angular(angular);
  return message;
}

}  // namespace bench

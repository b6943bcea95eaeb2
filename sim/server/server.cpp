#include "sim/server/server.h"

#include <fmt/format.h>

#include <bitset>
#include <optional>
#include <utility>

#include "sim/server/setup.h"
#include "sim/wire/robot_control.h"
#include "sim/wire/simulator_command.h"

namespace server {
namespace {

using wire::Problem;
namespace code = wire::code;
namespace proto = matchday::simulation;

// With sentences of up to 300 characters an answer stays below the 8192 bytes of wire::max_datagram_size.
constexpr int most_errors = 24;

/// The message, or why the bytes are not one.
template <class Message>
wire::Result<Message> parsed(std::string_view datagram, const char* name) {
  if (datagram.size() > wire::max_datagram_size) {
    return Problem{code::too_long, fmt::format("a datagram of {} bytes; at most {} are read", datagram.size(),
                                               wire::max_datagram_size)};
  }
  Message message;
  if (!message.ParseFromArray(datagram.data(), static_cast<int>(datagram.size()))) {
    return Problem{code::unreadable, fmt::format("these {} bytes are not a {}", datagram.size(), name)};
  }
  return message;
}

}  // namespace

/// Collects what could not be obeyed: counted at the port and told in the answer.
class Server::Problems {
 public:
  using Errors = google::protobuf::RepeatedPtrField<proto::SimulatorError>;
  Problems(PortCounts& counts, Errors& errors) : counts_(counts), errors_(errors) { ++counts_.messages; }
  ~Problems() {
    if (left_out_ == 0) return;
    errors_.Mutable(errors_.size() - 1)
        ->mutable_message()
        ->append(fmt::format(" (and {} more errors, not listed)", left_out_));
  }
  Problems(const Problems&) = delete;
  Problems& operator=(const Problems&) = delete;

  void add(const Problem& problem) {
    ++counts_.refused[problem.code];
    if (errors_.size() < most_errors) {
      wire::encode(problem, *errors_.Add());
    } else {
      ++left_out_;
    }
  }
  void add(const std::optional<Problem>& problem) {
    if (problem) add(*problem);
  }
  void add(const std::vector<Problem>& problems) {
    for (const Problem& problem : problems) add(problem);
  }

 private:
  PortCounts& counts_;
  Errors& errors_;
  int left_out_ = 0;
};

Server::Server(const Setup& setup, const world::PerTeam<std::vector<int>>& robots, double speed,
               std::uint16_t vision_port, wire::Epoch epoch)
    : simulation_(setup, robots), speed_(speed), vision_port_(vision_port), epoch_(epoch) {
  encode_geometry();
}

void Server::encode_geometry() { wire::encode_packet(simulation_.geometry(), geometry_); }

std::string Server::handle_control(std::string_view datagram) {
  proto::SimulatorResponse response;
  {
    Problems problems(control_counts_, *response.mutable_errors());
    const auto result = parsed<proto::SimulatorCommand>(datagram, "SimulatorCommand");
    if (const auto* problem = std::get_if<Problem>(&result)) {
      problems.add(*problem);
    } else {
      const auto& command = std::get<proto::SimulatorCommand>(result);
      if (command.has_config()) apply(command.config(), problems);
      if (command.has_control()) apply(command.control(), problems);
    }
  }
  return response.SerializeAsString();
}

void Server::apply(const proto::SimulatorConfig& config, Problems& problems) {
  Setup setup = simulation_.setup();
  if (config.has_geometry()) problems.add(server::apply(config.geometry(), setup));
  for (const proto::RobotSpecs& specs : config.robot_specs()) problems.add(server::apply(specs, setup));
  if (config.has_realism_config()) {
    problems.add(server::apply(config.realism_config(), simulation_.robots_on_field(), setup));
  }
  if (config.has_geometry() || config.robot_specs_size() > 0 || config.has_realism_config()) {
    simulation_.reconfigure(setup);
    encode_geometry();
  }
  if (config.has_vision_port()) {
    if (config.vision_port() >= 1 && config.vision_port() <= 65535) {
      vision_port_ = static_cast<std::uint16_t>(config.vision_port());
    } else {
      problems.add(Problem{code::port,
                           fmt::format("vision_port = {}: ports go from 1 to 65535", config.vision_port())});
    }
  }
}

void Server::apply(const proto::SimulatorControl& control, Problems& problems) {
  const auto obey = [&](const auto& result) {
    if (const auto* problem = std::get_if<Problem>(&result)) {
      problems.add(*problem);
    } else {
      problems.add(simulation_.teleport(std::get<0>(result)));
    }
  };
  for (const proto::TeleportRobot& robot : control.teleport_robot()) obey(wire::decode(robot));
  if (control.has_teleport_ball()) obey(wire::decode(control.teleport_ball()));
  if (control.has_simulation_speed()) {
    const float speed = control.simulation_speed();
    if (speed == 0 ||
        (speed >= static_cast<float>(slowest_speed) && speed <= static_cast<float>(fastest_speed))) {
      speed_ = speed;
    } else {
      problems.add(
          Problem{code::speed, fmt::format("simulation_speed = {}: must be 0 (pause) or from {} to {}", speed,
                                           slowest_speed, fastest_speed)});
    }
  }
}

std::string Server::handle_robots(world::Team team, std::string_view datagram) {
  proto::RobotControlResponse response;
  {
    Problems problems(robot_counts_[team], *response.mutable_errors());
    const auto result = parsed<proto::RobotControl>(datagram, "RobotControl");
    if (const auto* problem = std::get_if<Problem>(&result)) {
      problems.add(*problem);
    } else {
      std::bitset<robots_per_team> seen;
      for (const proto::RobotCommand& command : std::get<proto::RobotControl>(result).robot_commands()) {
        const auto order = wire::decode_order(command);
        if (const auto* bad = std::get_if<Problem>(&order)) {
          problems.add(*bad);
        } else if (seen[command.id()]) {
          problems.add(Problem{code::duplicate,
                               fmt::format("robot {} has two commands; the first one counts", command.id())});
        } else {
          seen.set(command.id());
          problems.add(simulation_.order(team, std::get<wire::RobotOrder>(order)));
        }
      }
    }
  }
  std::vector<wire::Feedback> feedback;
  for (const truth::Robot& robot : simulation_.truth().robots) {
    if (robot.id.team == team) feedback.push_back({robot.id.number, robot.ball_contact});
  }
  wire::encode(feedback, response);
  return response.SerializeAsString();
}

std::span<const VisionPacket> Server::step() {
  simulation_.step();
  const auto detections = simulation_.detections();
  packets_.resize(detections.size());
  for (std::size_t i = 0; i < detections.size(); ++i) {
    packets_[i].due = detections[i].t_sent;
    wire::encode_packet(detections[i], epoch_, packets_[i].bytes);
  }
  return packets_;
}

}  // namespace server

#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sim/server/simulation.h"
#include "sim/wire/epoch.h"
#include "sim/wire/problem.h"
#include "sim/wire/vision_packet.h"

namespace server {

/// What came in at one port.
struct PortCounts {
  std::uint64_t messages = 0;                         ///< datagrams, the bad ones too
  std::map<std::string_view, std::uint64_t> refused;  ///< problems by wire::code
};

/// A datagram for the vision group.
struct VisionPacket {
  world::Time due;  ///< t_sent: when it should leave
  std::string bytes;
};

/// The simulation protocol without sockets: bytes in, bytes out. Nothing here knows a clock.
class Server {
 public:
  /// @param vision_port  at first; clients may ask for another one
  /// @throws std::invalid_argument, see `Simulation`
  Server(const Setup& setup, const world::PerTeam<std::vector<int>>& robots, double speed,
         std::uint16_t vision_port, wire::Epoch epoch);

  /// A SimulatorCommand in, always a SimulatorResponse out. Parts that cannot be obeyed change nothing and
  /// have an error each (the first 24); config is done before control, all in the order of the message.
  std::string handle_control(std::string_view datagram);

  /// A RobotControl in, always a RobotControlResponse out: errors, and feedback of every robot of
  /// the team on the field.
  std::string handle_robots(world::Team team, std::string_view datagram);

  /// Advances by one tick; returns the camera frames that leave during it, in their order.
  std::span<const VisionPacket> step();

  /// Field and cameras as a datagram; changes with SimulatorConfig.
  const std::string& geometry() const { return geometry_; }

  double speed() const { return speed_; }                     ///< simulated seconds in a second; 0: paused
  std::uint16_t vision_port() const { return vision_port_; }  ///< where vision goes from now on
  world::Time time() const { return simulation_.time(); }
  const Simulation& simulation() const { return simulation_; }
  const PortCounts& control_counts() const { return control_counts_; }
  const PortCounts& robot_counts(world::Team team) const { return robot_counts_[team]; }

 private:
  class Problems;

  void apply(const matchday::simulation::SimulatorConfig& config, Problems& problems);
  void apply(const matchday::simulation::SimulatorControl& control, Problems& problems);
  void encode_geometry();

  Simulation simulation_;
  double speed_;
  std::uint16_t vision_port_;
  wire::Epoch epoch_;
  std::string geometry_;
  std::vector<VisionPacket> packets_;
  PortCounts control_counts_;
  world::PerTeam<PortCounts> robot_counts_;
};

/// The speeds that `simulation_speed` may have, beside 0.
inline constexpr double slowest_speed = 0.01;
inline constexpr double fastest_speed = 1000;

}  // namespace server

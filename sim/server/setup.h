#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <vector>

#include "sim/engine/model.h"
#include "sim/engine/realism.h"
#include "sim/proto/simulation.pb.h"
#include "sim/proto/vision.pb.h"
#include "sim/wire/problem.h"
#include "sim/wire/robot_control.h"
#include "sim/world/field.h"
#include "sim/world/robot_specs.h"

namespace server {

inline constexpr std::size_t robots_per_team = world::max_robot_number + 1;

/// What SimulatorConfig changes while the simulator runs, and what the engine's model is made of.
struct Setup {
  world::Field field;
  std::vector<world::Camera> cameras;  ///< none: as the realism says
  engine::Realism realism;
  world::PerTeam<std::array<world::RobotSpecs, robots_per_team>> specs;
  world::PerTeam<std::bitset<robots_per_team>> own_specs;  ///< set by robot_specs: not those of the realism
  world::PerTeam<std::array<wire::WheelAngles, robots_per_team>> wheels;
  std::uint64_t seed = 1;
};

/// All 16 robots of each team have the body of the realism.
Setup make_setup(const world::Field& field, const engine::Realism& realism, std::uint64_t seed);

/// Gives every robot without specs of its own the body of the realism.
void give_bodies(Setup& setup);

/// The engine's model with all 16 robots of each team and with cameras.
engine::Model model(const Setup& setup);

/// Says whether two set-ups make the same world, in all that messages can change; own_specs do not count.
bool same_world(const Setup& a, const Setup& b);

/// @throws std::invalid_argument in one sentence: what the engine refuses, more than 8 cameras, two with one
///         id, one below 0.5 m, a field below 1 m, a ball of less than 10 mm or more than 50 mm, wheel angles
///         that leave a direction open
void check(const Setup& setup);

/// Each applies one part of a SimulatorConfig. A part that cannot be obeyed changes nothing; the problems say
/// which and why.
std::vector<wire::Problem> apply(const matchday::vision::SSL_GeometryData& geometry, Setup& setup);
std::vector<wire::Problem> apply(const matchday::simulation::RobotSpecs& specs, Setup& setup);
/// @param robots  on the field
std::vector<wire::Problem> apply(const matchday::simulation::RealismConfig& realism, std::size_t robots,
                                 Setup& setup);

}  // namespace server

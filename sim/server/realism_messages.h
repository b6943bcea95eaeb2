#pragma once

#include <cstddef>
#include <vector>

#include "sim/engine/realism.h"
#include "sim/proto/simulation.pb.h"
#include "sim/wire/problem.h"

namespace server {

/// Changes what the payloads say: matchday.simulation.RealismMatchday (a preset, then single keys) and
/// ER-Force's RealismConfigErForce, each of whose fields stands for one of our keys (table in the README).
///
/// What cannot be obeyed changes nothing and is a problem: code::realism for an unknown key or preset or a
/// bad value, code::unsupported for what has no counterpart here.
///
/// @param robots, cameras  how many there are: ER-Force counts false balls per robot, we per camera
std::vector<wire::Problem> apply(const matchday::simulation::RealismConfig& message, std::size_t robots,
                                 std::size_t cameras, engine::Realism& realism);

}  // namespace server

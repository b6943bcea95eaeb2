#pragma once

#include <cstdint>

namespace physics {

struct ReferenceResult {
  std::uint64_t hash = 0;  ///< FNV-1a over the bits of all poses and velocities of every tick
  std::int64_t ticks = 0;
};

/// Plays the frozen scene by which all speeds are measured: reference "physics", 1c, "game", seed 1.
///
/// Twelve planar robots and a ball on 9 m by 6 m with walls and goals, one chaser per team, the others
/// driving to random targets, kicks of 2 to 8 m/s, 15 % of them chips. The file has its own use of Bullet and
/// shares nothing with the simulator: never change it, never make it faster, since its microseconds per tick
/// are the unit of every speed ratio.
ReferenceResult run_reference_scene(double seconds = 60);

}  // namespace physics

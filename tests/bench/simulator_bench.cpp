// Microseconds per tick of the simulator's parts, beside the reference scene. CPU time is the figure to read.

#include <benchmark/benchmark.h>

#include "sim/engine/engine.h"
#include "sim/physics/reference_scene.h"
#include "sim/vision/cameras.h"
#include "tests/sim/physics/chase.h"

namespace {

constexpr int ticks_per_round = 3600;

void per_tick(benchmark::State& state, double ticks) {
  state.counters["us_per_tick"] =
      benchmark::Counter(ticks * 1e-6, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void reference_scene(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(physics::run_reference_scene(60));
  per_tick(state, static_cast<double>(state.iterations()) * ticks_per_round);
}
BENCHMARK(reference_scene)->Unit(benchmark::kMillisecond);

// The same game in the simulator's physics, with its driver. Seed 21, whose load is next to the reference
// scene's: 2.1 contact pairs and 1.1 contact points on average and 31 kicks, against 2.0, 0.9 and 54 (other
// seeds: up to 3.5, 2.8 and 100).
void physics_chase(benchmark::State& state) {
  for (auto _ : state) {
    Chase chase(21);
    for (int i = 0; i < ticks_per_round; ++i) chase.tick();
  }
  per_tick(state, static_cast<double>(state.iterations()) * ticks_per_round);
}
BENCHMARK(physics_chase)->Unit(benchmark::kMillisecond);

void physics_idle(benchmark::State& state) {
  Chase chase(1);
  for (auto _ : state) {
    for (int i = 0; i < 4; ++i) chase.arena.step();
  }
  per_tick(state, static_cast<double>(state.iterations()));
}
BENCHMARK(physics_idle)->Unit(benchmark::kMicrosecond);

// Twelve robots and a ball spread over the field, four cameras, preset "measured".
void vision_tick(benchmark::State& state) {
  world::Geometry geometry;
  geometry.cameras = world::quarter_cameras(geometry.field);
  vision::Cameras cameras(geometry, engine::realism("measured").vision, 1);
  Chase chase(1);
  for (int i = 0; i < 300; ++i) chase.tick();
  std::vector<truth::Robot> robots;
  std::int64_t tick = 0;
  for (auto _ : state) {
    cameras.begin_tick();
    for (int substep = 1; substep <= 4; ++substep) {
      chase.arena.world.read_robots(robots);
      cameras.capture(substep, world::tick_time(tick, substep), chase.arena.ball(), robots);
    }
    benchmark::DoNotOptimize(cameras.delivered());
    ++tick;
  }
  per_tick(state, static_cast<double>(state.iterations()));
}
BENCHMARK(vision_tick)->Unit(benchmark::kMicrosecond);

}  // namespace

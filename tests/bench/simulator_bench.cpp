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

// All twelve drive at the ball and go on pushing: a heap of robots that stays.
void physics_crowd(benchmark::State& state) {
  std::vector<Arena::At> places;
  for (int i = 0; i < 12; ++i)
    places.push_back({world::direction(i * M_PI / 6) * (0.6 + 0.2 * (i % 3)), 0.5 * i});
  for (auto _ : state) {
    Arena arena(places);
    arena.world.place_ball(world::Vector2d(0, 0));
    for (int tick = 0; tick < ticks_per_round / 4; ++tick) {
      arena.world.read_robots(arena.robots);
      for (std::size_t i = 0; i < 12; ++i) {
        const world::Vector2d way = arena.ball().position.head<2>() - arena.robots[i].position;
        world::RobotCommand command;
        command.velocity_local = world::rotated(way.normalized() * 2, -arena.robots[i].orientation);
        arena.world.set_command(i, command);
      }
      arena.run(world::tick_length);
    }
  }
  per_tick(state, static_cast<double>(state.iterations()) * ticks_per_round / 4);
}
BENCHMARK(physics_crowd)->Unit(benchmark::kMillisecond);

struct Moment {
  truth::Ball ball;
  std::vector<truth::Robot> robots;
};

// Twelve robots and a ball in 100 moments of a chase: mostly some are at the ball.
std::vector<Moment> chased() {
  std::vector<Moment> moments(100);
  Chase chase(1);
  for (Moment& moment : moments) {
    for (int i = 0; i < 30; ++i) chase.tick();
    moment.ball = chase.arena.ball();
    chase.arena.world.read_robots(moment.robots);
  }
  return moments;
}

// The worst: all twelve in two rings round the ball at the centre mark, which all four cameras see.
std::vector<Moment> crowd() {
  Moment moment;
  moment.ball.position.z() = 0.0215;
  for (std::uint8_t i = 0; i < 12; ++i) {
    truth::Robot robot;
    robot.id = {i < 6 ? world::Team::Yellow : world::Team::Blue, static_cast<std::uint8_t>(i % 6)};
    robot.position = (i < 6 ? 0.18 : 0.37) * world::direction(i + 0.1);
    robot.orientation = i;
    moment.robots.push_back(robot);
  }
  return {moment};
}

// A tick of the four cameras of a preset.
void vision_tick(benchmark::State& state, const std::string& preset, const std::vector<Moment>& moments) {
  world::Geometry geometry;
  geometry.cameras = world::quarter_cameras(geometry.field);
  vision::Cameras cameras(geometry, engine::realism(preset).vision, 1);
  std::int64_t tick = 0;
  for (auto _ : state) {
    const Moment& moment = moments[static_cast<std::size_t>(tick) % moments.size()];
    cameras.begin_tick();
    for (int substep = 1; substep <= world::substeps_per_tick; ++substep) {
      cameras.capture(substep, world::tick_time(tick, substep), moment.ball, moment.robots);
    }
    benchmark::DoNotOptimize(cameras.delivered());
    ++tick;
  }
  per_tick(state, static_cast<double>(state.iterations()));
}
BENCHMARK_CAPTURE(vision_tick, none, "none", chased())->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(vision_tick, measured, "measured", chased())->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(vision_tick, harsh, "harsh", chased())->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(vision_tick, crowd, "measured", crowd())->Unit(benchmark::kMicrosecond);

}  // namespace

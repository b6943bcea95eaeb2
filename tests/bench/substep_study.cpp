// The physics with 1, 2, 4, 8 and 16 substeps per tick, as a Markdown table: how deep things overlap, what
// gets through, how energy and restitution drift, and what a tick costs.
//
// The costs of one run are to be compared with each other only: variants take turns, CPU time, medians.

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <vector>

#include "tests/sim/physics/chase.h"
#include "tests/sim/physics/sweeps.h"

namespace {

using world::Vector2d;

struct Row {
  int substeps = 0;
  Sweep robot, wall, goal;   // shots at 8 m/s
  double chip_energy = 0;    // largest relative change in flight
  double chip_carry = 0;     // error of the first hop's length [m]
  double rebound = 0;        // worst error of the speed off a robot's front, share of the right one
  double crowd_energy = 0;   // most that a substep added beyond what the drives can [J]
  double crowd_overlap = 0;  // of two robots [m]
  std::vector<double> cost;  // [us] per tick, one for each round
};

physics::Params with(int substeps) {
  physics::Params params;
  params.solver.substep_length = world::tick_length / substeps;
  return params;
}

void fly_chip(Row& row) {
  Arena arena({}, {}, with(row.substeps));
  const double v = 5 / std::sqrt(2.0);
  arena.place({-3, 0, 0.0215}, {v, 0, v});
  const auto energy = [&] {
    const truth::Ball& ball = arena.ball();
    return ball.velocity.squaredNorm() / 2 + physics::gravity * (ball.position.z() - 0.0215);
  };
  const double at_first = energy();
  truth::Ball last = arena.ball();  // in the air
  for (arena.step(); last.velocity.z() > arena.ball().velocity.z(); arena.step()) {
    last = arena.ball();
    row.chip_energy = std::max(row.chip_energy, std::abs(energy() / at_first - 1));
  }
  // From there on to the carpet along the parabola.
  const double down = last.velocity.z();
  const double fall = (down + std::sqrt(down * down + 2 * physics::gravity * (last.position.z() - 0.0215))) /
                      physics::gravity;
  const double carry = last.position.x() + 3 + last.velocity.x() * fall;
  row.chip_carry = std::abs(carry - 2 * v * v / physics::gravity);
}

void rebound(Row& row) {
  const double right = (0.6 * 2.5 - 0.046) / (2.5 + 0.046);
  for (const double speed : {2.0, 4.0, 8.0}) {
    for (int phase = 0; phase < 48; ++phase) {
      Arena arena({{{0, 0}, 0}}, {}, with(row.substeps));
      arena.roll({0.4 + speed * arena.length * phase / 48, 0}, {-speed, 0});
      double before = -speed;
      for (int i = 0; i < 1 / arena.length && arena.ball().velocity.x() < 0; ++i) {
        before = arena.ball().velocity.x();
        arena.step();
      }
      row.rebound = std::max(row.rebound, std::abs(-arena.ball().velocity.x() / before / right - 1));
    }
  }
}

// Twelve robots without power run into each other and the ball at 2 m/s: energy may only be lost.
void crowd(Row& row) {
  std::vector<Arena::At> places;
  for (int i = 0; i < 12; ++i) {
    places.push_back({world::direction(i * M_PI / 6) * (0.6 + 0.2 * (i % 3)), 0.5 * i});
  }
  world::RobotSpecs powerless;
  for (double* limit :
       {&powerless.max_acceleration, &powerless.max_acceleration_sideways, &powerless.max_brake,
        &powerless.max_brake_sideways, &powerless.max_angular_acceleration, &powerless.max_angular_brake}) {
    *limit = 1e-9;
  }
  Arena arena(places, powerless, with(row.substeps));
  arena.world.place_ball(Vector2d(0, 0));
  for (std::size_t i = 0; i < 12; ++i) arena.world.set_motion(i, -2 * places[i].position.normalized(), 0);
  const auto energy = [&] {
    arena.world.read_robots(arena.robots);
    const truth::Ball& ball = arena.ball();
    double sum =
        0.5 * 0.046 * (ball.velocity.squaredNorm() + 0.4 * 0.0215 * 0.0215 * ball.spin.squaredNorm());
    for (const truth::Robot& robot : arena.robots) {
      sum += 0.5 * 2.5 *
             (robot.velocity.squaredNorm() +
              0.5 * 0.09 * 0.09 * robot.angular_velocity * robot.angular_velocity);
    }
    return sum + 0.046 * physics::gravity * ball.position.z();
  };
  const double at_first = energy();
  double before = at_first;
  for (int i = 0; i < 3 / arena.length; ++i) {
    arena.step();
    const double now = energy();
    row.crowd_energy = std::max(row.crowd_energy, (now - before) / at_first);
    before = now;
    for (std::size_t a = 0; a < 12; ++a) {
      for (std::size_t b = a + 1; b < 12; ++b) {
        const double gap = (arena.robots[a].position - arena.robots[b].position).norm();
        row.crowd_overlap = std::max(row.crowd_overlap, 0.146 - gap);  // nearer than front to front
      }
    }
  }
}

void time_chase(Row& row) {
  const std::clock_t begin = std::clock();
  constexpr int ticks = 1200;
  for (const std::uint64_t seed : {3U, 8U, 21U}) {
    Chase chase(seed, with(row.substeps));
    for (int i = 0; i < ticks; ++i) chase.tick();
  }
  row.cost.push_back(static_cast<double>(std::clock() - begin) * 1e6 / CLOCKS_PER_SEC / (3 * ticks));
}

}  // namespace

int main() {
  std::vector<Row> rows;
  for (const int substeps : {1, 2, 4, 8, 16}) {
    rows.push_back({});
    rows.back().substeps = substeps;
  }
  for (Row& row : rows) {
    const physics::Params params = with(row.substeps);
    row.robot = shots_at_robot(8, 0, params);
    row.wall = shots_at_wall(8, params);
    row.goal = shots_at_goal(8, params);
    fly_chip(row);
    rebound(row);
    crowd(row);
  }
  for (int round = 0; round < 7; ++round) {
    for (Row& row : rows) time_chase(row);
  }
  std::printf(
      "| substeps per tick | went through at 8 m/s: robot, goal, wall | worst overlap then [mm] | chip in "
      "flight: "
      "energy, carry | worst rebound error | crowd: energy gained in a substep, overlap [mm] | us per tick "
      "|\n"
      "|---|---|---|---|---|---|---|\n");
  for (Row& row : rows) {
    std::nth_element(row.cost.begin(), row.cost.begin() + 3, row.cost.end());
    const auto percent = [](const Sweep& sweep) { return 100.0 * sweep.through / sweep.shots; };
    std::printf(
        "| %d | %.1f, %.1f, %.1f %% | %.1f, %.1f, %.1f | %.0e, %.2f mm | %.0f %% | %.0e, %.1f | %.1f |\n",
        row.substeps, percent(row.robot), percent(row.goal), percent(row.wall), row.robot.worst * 1000,
        row.goal.worst * 1000, row.wall.worst * 1000, row.chip_energy, row.chip_carry * 1000,
        row.rebound * 100, row.crowd_energy, row.crowd_overlap * 1000, row.cost[3]);
  }
  return 0;
}

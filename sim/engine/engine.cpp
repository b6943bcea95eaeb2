#include "sim/engine/engine.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "sim/engine/line_up.h"
#include "sim/engine/radio.h"
#include "sim/physics/world.h"
#include "sim/vision/cameras.h"

namespace engine {
namespace {

Model completed(Model model) {
  check(model);
  if (model.geometry.cameras.empty()) {
    const vision::Params& vision = model.realism.vision;
    model.geometry.cameras = world::camera_grid(model.geometry.field, vision.cameras, vision.camera_height);
  }
  for (const world::Team team : world::both_teams) {
    auto& robots = model.robots[team];
    std::sort(robots.begin(), robots.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
  }
  return model;
}

std::vector<world::RobotSpecs> all_robots(const Model& model) {
  std::vector<world::RobotSpecs> all = model.robots[world::Team::Yellow];
  const auto& blue = model.robots[world::Team::Blue];
  all.insert(all.end(), blue.begin(), blue.end());
  return all;
}

bool is_finite(const world::RobotCommand& command) {
  return command.velocity_local.allFinite() && std::isfinite(command.angular_velocity) &&
         std::isfinite(command.kick_speed) && std::isfinite(command.kick_angle) &&
         std::isfinite(command.dribbler_speed);
}

}  // namespace

struct Engine::State {
  explicit State(Model model_)
      : model(completed(std::move(model_))),
        specs(all_robots(model)),
        world(model.geometry.field, specs, model.realism.physics, model.seed),
        cameras(model.geometry, model.realism.vision, model.seed, model.realism.robots),
        queue(static_cast<std::size_t>(model.realism.radio.latency) + 1) {
    for (const world::Team team : world::both_teams) index[team].fill(-1);
    for (const world::RobotSpecs& one : specs) radios.emplace_back(one.id, model.realism.radio, model.seed);
    for (std::size_t i = 0; i < specs.size(); ++i) {
      index[specs[i].id.team][specs[i].id.number] = static_cast<int>(i);
    }
    for (const world::Team team : world::both_teams) {
      const bool positive = (team == world::Team::Blue) == model.blue_on_positive_half;
      const auto poses =
          line_up(model.geometry.field, positive ? world::Side::Positive : world::Side::Negative,
                  model.robots[team].size());
      for (std::size_t i = 0; i < poses.size(); ++i) {
        world.put_robot(*robot(model.robots[team][i].id), poses[i].position, poses[i].orientation);
      }
    }
    world.place_ball({0, 0});
    read_poses();
  }

  std::optional<std::size_t> robot(world::RobotId id) const {
    if (id.number > world::max_robot_number || index[id.team][id.number] < 0) return std::nullopt;
    return static_cast<std::size_t>(index[id.team][id.number]);
  }

  void read_poses() {
    frame.ball = world.ball();
    world.read_robots(frame.robots);
  }

  void apply(const world::PerTeam<world::TeamCommands>& commands) {
    for (RobotRadio& radio : radios) radio.begin_tick();
    for (const world::Team team : world::both_teams) {
      for (const world::RobotCommand& command : commands[team]) {
        const auto addressed = robot({team, command.number});
        if (addressed && is_finite(command)) radios[*addressed].send(command);
      }
    }
    for (std::size_t i = 0; i < specs.size(); ++i) world.set_command(i, radios[i].heard());
  }

  Model model;
  std::vector<world::RobotSpecs> specs;                                // of both teams, sorted by id
  world::PerTeam<std::array<int, world::max_robot_number + 1>> index;  // into specs, by number; -1 for none
  physics::World world;
  vision::Cameras cameras;
  std::vector<RobotRadio> radios;                          // as specs
  std::vector<world::PerTeam<world::TeamCommands>> queue;  // ring of latency + 1 ticks
  truth::Frame frame;
  std::vector<vision::Cameras*> guests;  // cameras of others
  Timing* timing = nullptr;
};

struct Snapshot::Values {
  physics::State physics;
  vision::Cameras cameras;
  std::vector<RobotRadio> radios;
  std::vector<world::PerTeam<world::TeamCommands>> queue;
  truth::Frame frame;
};

Snapshot::Snapshot(std::unique_ptr<Values> values) : values_(std::move(values)) {}
Snapshot::Snapshot(const Snapshot& other) : values_(std::make_unique<Values>(*other.values_)) {}
Snapshot& Snapshot::operator=(const Snapshot& other) {
  if (this != &other) values_ = std::make_unique<Values>(*other.values_);
  return *this;
}
Snapshot::Snapshot(Snapshot&&) noexcept = default;
Snapshot& Snapshot::operator=(Snapshot&&) noexcept = default;
Snapshot::~Snapshot() = default;

Engine::Engine(Model model) : state_(std::make_unique<State>(std::move(model))) {}
Engine::~Engine() = default;
Engine::Engine(Engine&&) noexcept = default;
Engine& Engine::operator=(Engine&&) noexcept = default;

const Model& Engine::model() const { return state_->model; }

void Engine::step(const world::PerTeam<world::TeamCommands>& commands) {
  State& state = *state_;
  truth::Frame& frame = state.frame;

  const auto slots = static_cast<std::int64_t>(state.queue.size());
  world::PerTeam<world::TeamCommands>& newest = state.queue[static_cast<std::size_t>(frame.tick % slots)];
  newest = commands;
  // With a latency of L the slot after the newest one holds the commands of L ticks
  // ago; at first it is empty.
  state.apply(state.queue[static_cast<std::size_t>((frame.tick + 1) % slots)]);

  frame.contacts.clear();
  frame.kicks.clear();
  state.cameras.begin_tick();
  for (vision::Cameras* guest : state.guests) guest->begin_tick();
  for (int substep = 1; substep <= world::substeps_per_tick; ++substep) {
    const world::Time now = world::tick_time(frame.tick, substep);
    state.world.substep(now, frame.contacts, frame.kicks);
    const bool last = substep == world::substeps_per_tick;
    const bool guests_look = std::any_of(state.guests.begin(), state.guests.end(),
                                         [&](const auto* guest) { return guest->captures_after(substep); });
    if (last || guests_look || state.cameras.captures_after(substep)) {
      state.read_poses();
      const auto begin = state.timing != nullptr ? std::chrono::steady_clock::now()
                                                 : std::chrono::steady_clock::time_point{};
      state.cameras.capture(substep, now, frame.ball, frame.robots);
      if (state.timing != nullptr) state.timing->vision += std::chrono::steady_clock::now() - begin;
      for (vision::Cameras* guest : state.guests) guest->capture(substep, now, frame.ball, frame.robots);
    }
  }
  ++frame.tick;
  frame.time = world::tick_time(frame.tick);
}

void Engine::also_seen_by(vision::Cameras& cameras) { state_->guests.push_back(&cameras); }

void Engine::measure(Timing* timing) { state_->timing = timing; }

std::int64_t Engine::tick() const { return state_->frame.tick; }
world::Time Engine::time() const { return state_->frame.time; }
const truth::Frame& Engine::truth() const { return state_->frame; }
std::span<const world::Detection> Engine::detections() const { return state_->cameras.delivered(); }

Snapshot Engine::snapshot() const {
  const State& state = *state_;
  return Snapshot(std::make_unique<Snapshot::Values>(
      Snapshot::Values{state.world.state(), state.cameras, state.radios, state.queue, state.frame}));
}

void Engine::restore(const Snapshot& snapshot) {
  State& state = *state_;
  const Snapshot::Values& values = *snapshot.values_;
  if (values.radios.size() != state.radios.size() || values.queue.size() != state.queue.size()) {
    throw std::invalid_argument(
        "snapshot: it is of another model, with " + std::to_string(values.radios.size()) +
        " robots and a latency of " + std::to_string(values.queue.size() - 1) + " ticks; this one has " +
        std::to_string(state.radios.size()) + " and " + std::to_string(state.queue.size() - 1));
  }
  state.world.restore(values.physics);
  state.cameras = values.cameras;
  state.radios = values.radios;
  state.queue = values.queue;
  state.frame = values.frame;
}

void Engine::place_ball(const world::Vector2d& spot) {
  state_->world.place_ball(spot);
  state_->read_poses();
}

void Engine::put_ball(const truth::Ball& ball) {
  state_->world.place_ball(ball);
  state_->read_poses();
}

bool Engine::spot_is_free(const world::Vector2d& spot, double clearance) const {
  return state_->world.distance_to_robots(spot) > clearance;
}

void Engine::push_robots_out(const world::Vector2d& spot, double clearance) {
  state_->world.push_robots_out(spot, clearance);
  state_->read_poses();
}

void Engine::remove_robot(world::RobotId id) {
  if (const auto robot = state_->robot(id)) state_->world.remove_robot(*robot);
  state_->read_poses();
}

void Engine::put_robot(world::RobotId id, const world::Vector2d& position, double orientation,
                       const world::Vector2d& velocity, double angular_velocity) {
  const auto robot = state_->robot(id);
  if (!robot) {
    throw std::invalid_argument(std::string("the model has no ") + name(id.team) + " robot " +
                                std::to_string(id.number));
  }
  state_->world.put_robot(*robot, position, orientation);
  state_->world.set_motion(*robot, velocity, angular_velocity);
  state_->read_poses();
}

}  // namespace engine

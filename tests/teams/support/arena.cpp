#include "tests/teams/support/arena.h"

#include <ctime>

namespace support {
namespace {

// Of this thread: the machine may be busy with other things.
double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace

Arena::Arena(Side yellow, Side blue, std::uint64_t seed, const char* realism) {
  engine::Model model;
  model.geometry.field = world::rule_set("ssl-2015").field;
  model.geometry.cameras = world::quarter_cameras(model.geometry.field);
  model.realism = engine::realism(realism);
  model.seed = seed;
  const world::PerTeam<Side*> sides{&yellow, &blue};
  for (const world::Team team : world::both_teams) {
    if (sides[team]->make) {
      model.robots[team] = engine::standard_robots(team, sides[team]->robots, sides[team]->speed_factor);
    }
  }
  engine_ = std::make_unique<engine::Engine>(model);
  for (const world::Team team : world::both_teams) {
    if (!sides[team]->make) continue;
    kit::Setup setup;
    setup.team = team;
    setup.seed = seed;
    setup.geometry = model.geometry;
    setup.robots = model.robots[team];
    setup.vision_delay = model.realism.vision.delay;
    setup.command_latency = model.realism.radio.latency;
    Player& player = players_[team];
    player.team = sides[team]->make(setup);
    player.tracker.emplace(model.geometry);
    player.looker.emplace(setup);
    keepers_[team] = player.team->keeper(setup);
    told_.teams[team].keeper = keepers_[team];
  }
}

void Arena::start_referee(world::Duration half_length) {
  referee::Setup setup;
  setup.rules = world::rule_set("ssl-2015");
  setup.rules.half_length = half_length;
  setup.geometry = engine_->model().geometry;
  setup.keeper = keepers_;
  for (const world::Team team : world::both_teams) {
    setup.robots[team] = static_cast<int>(engine_->model().robots[team].size());
  }
  referee_ = std::make_unique<referee::Referee>(setup);
}

void Arena::tell(world::Command command, std::optional<world::Vector2d> designated) {
  told_.command = command;
  told_.command_counter += 1;
  told_.command_time = engine_->time();
  told_.designated_position = designated;
}

bool Arena::tick() {
  engine_->step(commands_);
  const std::span<const world::Detection> detections = engine_->detections();
  calls_ = {};
  if (referee_) {
    const referee::Output output = referee_->update(detections);
    calls_ = output.calls;
    ball_reset_.update(output.ball_reset, referee_->state(), *engine_);
    if (output.finished) return false;
  }
  const world::RefereeMessage& message = referee_ ? referee_->message() : told_;
  const double begin = cpu_seconds();
  for (const world::Team team : world::both_teams) {
    Player& player = players_[team];
    if (!player.team) continue;
    player.tracker->update(detections);
    std::vector<std::uint8_t> contacts;
    for (const truth::Robot& robot : engine_->truth().robots) {
      if (robot.id.team == team && robot.ball_contact) contacts.push_back(robot.id.number);
    }
    commands_[team].clear();
    const kit::View& view = player.looker->look(engine_->tick(), player.tracker->frame(), message, contacts);
    if (view.game.phase != kit::Phase::Halt) player.team->play(view, commands_[team]);
    player.looker->sent(commands_[team]);
  }
  thinking_seconds_ += cpu_seconds() - begin;
  return true;
}

}  // namespace support

#include "experiments/host/game_hash.h"

#include <gtest/gtest.h>

#include <functional>
#include <set>

namespace host {
namespace {

struct Tick {
  truth::Frame truth;
  world::PerTeam<world::TeamCommands> commands;
  world::RefereeMessage message;
  std::optional<world::Vector2d> ball_reset;
};

Tick example() {
  Tick tick;
  tick.truth.tick = 3;
  tick.truth.robots = {{.id = {world::Team::Yellow, 1}}, {.id = {world::Team::Blue, 2}}};
  tick.commands.yellow = {{.number = 1}};
  return tick;
}

std::string hash_of(const Tick& tick, int times = 1) {
  GameHash hash;
  for (int i = 0; i < times; ++i) hash.add(tick.truth, tick.commands, tick.message, tick.ball_reset);
  return hash.digits();
}

TEST(GameHash, EverythingThatHappensChangesIt) {
  const std::vector<std::function<void(Tick&)>> changes = {
      [](Tick&) {},
      [](Tick& t) { t.truth.tick = 4; },
      [](Tick& t) { t.truth.ball.position.x() = 1e-300; },
      [](Tick& t) { t.truth.ball.position.z() = 1e-300; },
      [](Tick& t) { t.truth.ball.velocity.y() = 1; },
      [](Tick& t) { t.truth.ball.spin.y() = 1; },
      [](Tick& t) { t.truth.robots[0].id.team = world::Team::Blue; },
      [](Tick& t) { t.truth.robots[1].id.number = 3; },
      [](Tick& t) { t.truth.robots[1].position.y() = -0.0; },
      [](Tick& t) { t.truth.robots[1].orientation = 1; },
      [](Tick& t) { t.truth.robots[1].velocity.x() = 1; },
      [](Tick& t) { t.truth.robots[1].angular_velocity = 1; },
      [](Tick& t) { t.truth.robots.pop_back(); },
      [](Tick& t) { t.commands.yellow[0].number = 2; },
      [](Tick& t) { t.commands.yellow[0].velocity_local.x() = 1; },
      [](Tick& t) { t.commands.yellow[0].angular_velocity = 1; },
      [](Tick& t) { t.commands.yellow[0].kick_speed = 1; },
      [](Tick& t) { t.commands.yellow[0].kick_angle = 1; },
      [](Tick& t) { t.commands.yellow[0].dribbler_speed = 1; },
      [](Tick& t) { std::swap(t.commands.yellow, t.commands.blue); },
      [](Tick& t) { t.message.command.kind = world::CommandKind::Stop; },
      [](Tick& t) {
        t.message.command = {world::CommandKind::Direct, world::Team::Yellow};
      },
      [](Tick& t) {
        t.message.command = {world::CommandKind::Direct, world::Team::Blue};
      },
      [](Tick& t) { t.message.command_counter = 1; },
      [](Tick& t) { t.message.stage = world::Stage::First; },
      [](Tick& t) { t.message.teams.blue.score = 1; },
      [](Tick& t) { t.message.teams.yellow.score = 1; },
      [](Tick& t) {
        t.ball_reset = world::Vector2d{0, 0};
      },
      [](Tick& t) {
        t.ball_reset = world::Vector2d{0, 1};
      },
  };
  std::set<std::string> seen;
  for (const auto& change : changes) {
    Tick tick = example();
    change(tick);
    seen.insert(hash_of(tick));
  }
  EXPECT_EQ(seen.size(), changes.size());
}

TEST(GameHash, CountsTicks) { EXPECT_NE(hash_of(example(), 1), hash_of(example(), 2)); }

TEST(GameHash, IgnoresWhatIsNoPartOfTheGame) {
  Tick tick = example();
  tick.message.teams.yellow.name = "another name";
  tick.message.status = "text";
  tick.message.command.team = world::Team::Blue;  // HALT is nobody's
  EXPECT_EQ(hash_of(tick), hash_of(example()));
}

TEST(GameHash, OfNothingIsThatOfXxh3) {
  // XXH3-128 of no bytes with seed 0, as the command `xxh128sum /dev/null` prints it.
  EXPECT_EQ(GameHash().digits(), "99aa06d3014798d86001c324468d497f");
}

}  // namespace
}  // namespace host

#include "autoref/watcher.h"

#include <gtest/gtest.h>

namespace autoref {
namespace {

using world::Team;

/// STOP that was given `age` before the first image; a robot drives at 2 m/s from then on.
/// @return when it was seen to be too fast [s] after the first image
double too_fast_after(double age) {
  const world::RuleSet& rules = world::rule_set("ssl-2015");
  world::Geometry geometry;
  geometry.field = rules.field;
  Watcher watcher(rules, geometry);
  for (std::int64_t tick = 1; tick < 240; ++tick) {
    world::Detection image;
    image.t_capture = image.t_sent = world::tick_time(tick);
    image.balls.push_back({.position = {3, 2}});
    const double way = 2.0 * static_cast<double>(tick) / 60;
    image.robots.push_back({.team = Team::Blue, .number = 5, .position = {-4 + way, 0}, .orientation = 0.0});
    for (const Sighting& sighting : watcher.update({&image, 1})) {
      if (std::holds_alternative<world::BotTooFastInStop>(sighting.event.what)) {
        return world::seconds(sighting.time - world::tick_time(1));
      }
    }
    if (tick > 1) continue;
    world::RefereeMessage message;
    message.stage = world::Stage::First;
    message.command = {world::CommandKind::Stop, Team::Yellow};
    message.command_counter = 1;
    message.time = world::Time{world::from_seconds(5000)};  // a clock of its own
    message.command_time = message.time - world::from_seconds(age);
    watcher.follow(message);
  }
  return -1;
}

TEST(Watcher, CountsTheGraceOfAStopFromItsCommand) {
  // 2 s of grace and 0.3 s at that speed; a few frames of the filter.
  EXPECT_NEAR(too_fast_after(0), 2.3, 0.06);
  EXPECT_NEAR(too_fast_after(1), 1.3, 0.06);
}

}  // namespace
}  // namespace autoref

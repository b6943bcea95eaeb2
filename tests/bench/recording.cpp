#include "tests/bench/recording.h"

namespace hot {

Recording recorded(const kit::MakeTeam& players, double seconds) {
  Game game(players);
  game.keep = true;
  Recording recording;
  recording.config = game.config();
  recording.setup = game.setup();
  for (const world::Team team : world::both_teams) recording.hellos[team] = game.hello(team);
  while (world::seconds(game.engine().time()) < seconds) {
    Tick& tick = recording.ticks.emplace_back();
    tick.commands = game.commands();
    if (!game.tick()) break;
    tick.truth = game.engine().truth();
    const auto detections = game.engine().detections();
    tick.detections.assign(detections.begin(), detections.end());
    tick.frame = game.referee().frame();
    tick.message = game.referee().message();
    tick.message_changed = game.output().message_changed;
    for (const world::Team team : world::both_teams) {
      tick.payloads[team] = game.payload(team);
      tick.replies[team] = game.reply(team);
    }
  }
  return recording;
}

}  // namespace hot

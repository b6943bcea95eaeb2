// Plays whole games of team-reference and says how often each way to find the last toucher was right when the
// ball left the field: exits_study PRESET GAMES [FIRST_SEED]
#include <fmt/format.h>

#include <cstdlib>
#include <iostream>

#include "experiments/host/play.h"
#include "tests/autoref/touch/exits.h"

int main(int argc, char** argv) {
  if (argc < 3 || argc > 4) {
    std::cerr << "exits_study: give PRESET GAMES [FIRST_SEED], as in: exits_study measured 10\n";
    return 2;
  }
  const std::string preset = argv[1];
  const int games = std::atoi(argv[2]);
  const int first_seed = argc == 4 ? std::atoi(argv[3]) : 1;
  if (games < 1 || first_seed < 0) {
    std::cerr << "exits_study: GAMES and FIRST_SEED are whole numbers, GAMES from 1\n";
    return 2;
  }

  std::vector<study::Exit> exits;
  std::vector<study::Witness> witnesses;
  for (int game = 0; game < games; ++game) {
    record::MatchConfig config;
    for (const world::Team team : world::both_teams) {
      config.teams[team].name = "team-reference";
      config.teams[team].command = {BIN_DIR "/team-reference"};
    }
    config.seed = static_cast<std::uint64_t>(first_seed + game);
    config.realism.preset = preset;
    study::ExitStudy study(world::Field{}, study::all_witnesses(world::Field{}));
    world::Time last_frame;
    host::Options options;
    options.on_tick = [&](const engine::Engine& engine, const referee::Referee& referee) {
      const bool fresh = referee.frame().time > last_frame;
      last_frame = referee.frame().time;
      study.tick(engine.truth(), fresh ? &referee.frame() : nullptr, engine.detections(), referee.state());
    };
    try {
      host::play(config, options);
    } catch (const std::exception& error) {
      std::cerr << "exits_study: " << error.what() << "\n";
      return 2;
    }
    exits.insert(exits.end(), study.exits().begin(), study.exits().end());
    witnesses = study.witnesses();
    std::cerr << fmt::format("game {} of {}: {} exits\n", game + 1, games, study.exits().size());
  }
  std::cout << study::table(exits, witnesses) << "\n" << study::calibration(exits, witnesses);
}

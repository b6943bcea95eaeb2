#include <algorithm>
#include <iostream>
#include <stdexcept>

#include "experiments/builds/builds.h"
#include "experiments/commands.h"
#include "experiments/exit_code.h"
#include "experiments/experiment.h"
#include "experiments/one_game.h"
#include "experiments/runner/program_files.h"
#include "experiments/schedule/schedule.h"
#include "experiments/tell.h"

namespace commands {
namespace {

/// The last attempt at that game.
const record::Attempt& recorded(const Experiment& experiment, const record::GameKey& key) {
  const auto found = std::find_if(experiment.attempts.rbegin(), experiment.attempts.rend(),
                                  [&](const record::Attempt& attempt) { return attempt.key == key; });
  if (found == experiment.attempts.rend()) {
    throw std::invalid_argument("game '" + record::game_id(key) + "' has not been played yet");
  }
  return *found;
}

}  // namespace

int replay(const ReplayOptions& options) {
  Experiment experiment = read_experiment(options.folder);
  builds::prepare(experiment.design, options.folder / "builds", std::cerr);
  const schedule::Game game = schedule::find_game(experiment.design, options.game);
  const record::Attempt& attempt = recorded(experiment, game.key);

  record::MatchConfig config = game.config;
  config.log = options.log;
  config.directory = options.team_logs;
  if (!config.directory.empty()) std::filesystem::create_directories(config.directory);
  runner::team_files(config.teams.yellow, "yellow");
  runner::team_files(config.teams.blue, "blue");

  std::cout << options.game << ", attempt " << attempt.attempt << ", team A is " << world::name(game.a_colour)
            << "\n";
  tell_circumstances(config, std::cout);
  const OneGame again = play_one_game(config, &std::cout);
  tell_result(config, again.record, std::cout);
  if (again.signal) return signal_base + *again.signal;

  if (again.record.hash == attempt.record.hash && again.record.termination == attempt.record.termination) {
    std::cout << "the same game as in the ledger\n";
    return done;
  }
  std::cout << "not the game in the ledger (" << record::name(attempt.record.termination) << ", hash "
            << (attempt.record.hash.empty() ? "none" : attempt.record.hash)
            << "): a team is not deterministic, or a program was changed since\n";
  return different;
}

}  // namespace commands

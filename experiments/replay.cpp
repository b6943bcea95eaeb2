#include <algorithm>
#include <iostream>
#include <stdexcept>

#include "experiments/commands.h"
#include "experiments/exit_code.h"
#include "experiments/experiment.h"
#include "experiments/host/recorded_teams.h"
#include "experiments/one_game.h"
#include "experiments/output_file.h"
#include "experiments/runner/audit.h"
#include "experiments/runner/program_files.h"
#include "experiments/schedule/schedule.h"
#include "experiments/start.h"
#include "experiments/tell.h"
#include "sim/console/printable.h"

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

/// The recorded replies of that attempt.
std::filesystem::path replies_of(const std::filesystem::path& folder, const record::Attempt& attempt) {
  const std::string id = record::game_id(attempt.key);
  const std::filesystem::path place = folder / "games" / id / std::to_string(attempt.attempt);
  const auto replies = runner::kept_replies(place);
  if (!replies) {
    throw std::invalid_argument("--recorded: the replies of game '" + id + "' were not kept in " +
                                place.string() +
                                ": only those of faulty and sampled games are; without --recorded it is "
                                "played again from its seed");
  }
  return *replies;
}

/// What decides how the game goes.
record::MatchConfig game_in(record::MatchConfig config) {
  config.continuation.reset();
  config.recording.reset();
  config.log.reset();
  config.directory.clear();
  for (const world::Team team : world::both_teams) config.teams[team].directory.clear();
  return config;
}

/// All of a recording is read before any of it is played.
///
/// @throws std::runtime_error naming file and place when it is damaged
/// @throws std::invalid_argument naming the file when it is cut off or of another game
void check_recording(const std::filesystem::path& file, const record::MatchConfig& config,
                     const record::Attempt& attempt) {
  const host::RecordedLength length = host::recorded_length(file);
  if (game_in(host::recorded_config(file)) != game_in(config)) {
    throw std::invalid_argument(file.string() + ": is the recording of another game than " +
                                record::game_id(attempt.key) +
                                ": seed, teams, sides, rules or realism are not the same");
  }
  // A game that ended by a fault has a recording without an end.
  if (length.cut && attempt.record.termination == record::Termination::Finished) {
    throw std::invalid_argument(file.string() + ": is cut off after tick " + std::to_string(length.ticks) +
                                "; without --recorded the game is played again from its seed");
  }
}

/// What follows from the game having been played again.
int compare(const record::MatchRecord& again, const record::Attempt& attempt, bool recorded) {
  const record::MatchRecord& original = attempt.record;
  if (original.hash.empty()) {
    std::cout << "the ledger has no hash of this game (" << record::name(original.termination) << ": "
              << console::printable(original.reason) << ")\n";
    return done;
  }
  // Recorded replies go up to the fault, which is the teams' and not in them.
  const bool ended_alike = recorded || again.termination == original.termination;
  if (again.hash == original.hash && ended_alike) {
    std::cout << (original.termination == record::Termination::Finished || !recorded
                      ? "the same game as in the ledger\n"
                      : "the same game as in the ledger, up to its fault: " +
                            console::printable(original.reason) + "\n");
    return done;
  }
  // As when the league log cannot be written; recorded replies that lead elsewhere are no such case.
  const bool broken = again.reason.starts_with("internal error: ");
  if (broken || (!recorded && again.at_fault == record::Party::Harness)) {
    std::cout << "it could not be played again: " << console::printable(again.reason) << "\n";
    return faults;
  }
  std::cout << "not the game in the ledger (" << record::name(original.termination) << ", hash "
            << console::printable(original.hash) << "): "
            << (recorded
                    ? "it was played by another build of matchday, or on another kind of processor\n"
                    : "a team is not deterministic, a program was changed since, or needs what it does not "
                      "see with this isolation\n");
  return different;
}

}  // namespace

int replay(const ReplayOptions& options) {
  check_temporary_folder(Games::Here);
  check_output("--log", options.log, ".log");
  Experiment experiment = read_experiment(options.folder);
  host::Options settings;
  std::string isolation;
  if (!options.recorded)
    settings = live_settings(experiment.design, options.folder, options.live, &isolation);
  const schedule::Game game = schedule::find_game(experiment.design, options.game);
  const record::Attempt& attempt = recorded(experiment, game.key);

  record::MatchConfig config = game.config;
  config.log = options.log;
  config.directory = options.team_logs;
  make_team_logs(config.directory);
  settings.memory_limit = experiment.design.limits.team_memory << 20;
  set_team_time(experiment.design.limits.team_time, settings);
  settings.must_be_plausible = true;  // as when it was played, so that it ends alike
  if (options.recorded) {
    config.continuation = record::Continuation{replies_of(options.folder, attempt), std::nullopt};
    check_recording(config.continuation->recording, config, attempt);
    if (attempt.record.ticks > 0) settings.last_tick = attempt.record.ticks;
  } else {
    runner::team_files(config.teams.yellow, "yellow");
    runner::team_files(config.teams.blue, "blue");
  }

  std::cout << options.game << ", attempt " << attempt.attempt << ", team A is " << world::name(game.a_colour)
            << "\n";
  if (!isolation.empty()) std::cout << isolation << "\n";
  tell_circumstances(config, std::cout);
  const OneGame again = play_one_game(config, &std::cout, false, settings);
  tell_result(config, again.record, std::cout);
  if (again.signal) return signal_base + *again.signal;
  return compare(again.record, attempt, options.recorded);
}

}  // namespace commands

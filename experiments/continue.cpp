#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "experiments/commands.h"
#include "experiments/host/recorded_teams.h"
#include "experiments/one_game.h"
#include "experiments/runner/program_files.h"
#include "experiments/schedule/command_line.h"

namespace commands {
namespace {

void replace_team(const std::string& command, const std::string& flag, record::TeamConfig& team) {
  if (command.empty()) return;
  try {
    team.command = schedule::split_command(command);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(flag + ": " + error.what());
  }
  team.name = schedule::usual_name(team.command);
}

}  // namespace

int continue_game(const ContinueOptions& options) {
  record::MatchConfig config = host::recorded_config(options.recording);
  // All of it: damage is told before the game.
  const std::int64_t ticks = host::recorded_length(options.recording).ticks;
  config.continuation = record::Continuation{options.recording, std::nullopt};
  if (options.from) {
    config.continuation->tick = std::llround(*options.from * world::ticks_per_second);
    if (*config.continuation->tick > ticks) {
      throw std::invalid_argument(fmt::format("--from {:g}: the recording {} ends at {:.1f} s", *options.from,
                                              options.recording.string(),
                                              static_cast<double>(ticks) * world::tick_length));
    }
    replace_team(options.blue, "--blue", config.teams.blue);
    replace_team(options.yellow, "--yellow", config.teams.yellow);
    runner::team_files(config.teams.blue, "--blue");
    runner::team_files(config.teams.yellow, "--yellow");
  } else if (!options.blue.empty() || !options.yellow.empty()) {
    throw std::invalid_argument("another team needs a moment to take over: add --from SECONDS");
  }
  config.log = options.output.log;
  config.recording = options.output.recording;
  config.directory = options.output.team_logs;
  if (config.recording && std::filesystem::weakly_canonical(*config.recording) ==
                              std::filesystem::weakly_canonical(options.recording)) {
    throw std::invalid_argument("--record " + config.recording->string() +
                                ": is the recording that is being played; give another file");
  }
  return tell_one_game(config, options.output.json, options.output.explain, options.isolation);
}

}  // namespace commands

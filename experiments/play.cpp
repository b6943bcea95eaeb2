#include "experiments/host/play.h"

#include <iostream>
#include <stdexcept>

#include "experiments/commands.h"
#include "experiments/exit_code.h"
#include "experiments/one_game.h"
#include "experiments/output_file.h"
#include "experiments/record/json_text.h"
#include "experiments/runner/program_files.h"
#include "experiments/schedule/command_line.h"
#include "experiments/start.h"
#include "experiments/tell.h"

namespace commands {
namespace {

record::TeamConfig team(const TeamOptions& options, const std::string& flag) {
  record::TeamConfig team;
  try {
    team.command = schedule::split_command(options.command);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(flag + ": " + error.what());
  }
  runner::team_files(team, flag);
  team.name = options.name.empty() ? schedule::usual_name(team.command) : options.name;
  team.robots = options.robots;
  team.speed_factor = options.speed_factor;
  return team;
}

}  // namespace

int play(const PlayOptions& options) {
  record::MatchConfig config;
  config.teams.blue = team(options.blue, "--blue");
  config.teams.yellow = team(options.yellow, "--yellow");
  config.seed = options.seed;
  config.rules = options.rules;
  config.realism = realism_config(options.realism);
  config.half_length = options.half_length;
  config.winner = options.winner;
  config.blue_on_positive_half = !options.blue_on_negative_half;
  config.first_kickoff = options.blue_kicks_off ? world::Team::Blue : world::Team::Yellow;
  config.log = options.output.log;
  config.recording = options.output.recording;
  config.directory = options.output.team_logs;
  return tell_one_game(config, options.output.json, options.output.explain, options.isolation,
                       options.team_time);
}

int tell_one_game(const record::MatchConfig& config, bool json, bool explain,
                  const IsolationOptions& isolation, const schedule::TeamTime& time) {
  check_temporary_folder(Games::Here);
  host::check(config);
  check_output("--log", config.log, ".log");
  check_output("--record", config.recording, ".replies");
  make_team_logs(config.directory);

  const bool live = !config.continuation || config.continuation->tick;
  std::string sentence;
  host::Options settings = live ? isolated_game(isolation, &sentence) : host::Options{};
  set_team_time(time, settings);
  if (live && !json) std::cout << sentence << "\n";
  if (!json) tell_circumstances(config, std::cout);
  const OneGame game = play_one_game(config, json ? nullptr : &std::cout, explain, settings);
  if (json) {
    std::cout << "{\"config\":" << record::to_json(config) << ",\"record\":" << record::to_json(game.record)
              << "}\n";
  } else {
    tell_result(config, game.record, std::cout);
  }
  if (game.signal) return signal_base + *game.signal;
  return game.record.at_fault == record::Party::Nobody ? done : faults;
}

}  // namespace commands

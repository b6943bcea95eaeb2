#pragma once

#include <string>
#include <vector>

#include "experiments/record/match_config.h"
#include "tests/fakes/programs.h"

namespace fakes {

/// The command line of the scripted team; see tests/fakes/fake_team.cpp for the modes.
inline std::vector<std::string> fake_team(const std::string& mode, int at_tick = 5) {
  return {fakes::bin_dir() + "/fake-team", "--mode", mode, "--at", std::to_string(at_tick)};
}

/// The same for the modes that take time for each answer.
inline std::vector<std::string> slow_team(const std::string& mode, int milliseconds, int at_tick = 1) {
  std::vector<std::string> command = fake_team(mode, at_tick);
  command.insert(command.end(), {"--milliseconds", std::to_string(milliseconds)});
  return command;
}

/// A short game between two scripted teams: two halves of 10 s.
inline record::MatchConfig short_game(const std::string& yellow_mode, const std::string& blue_mode) {
  record::MatchConfig config;
  config.teams.yellow.name = "Fake Y";
  config.teams.yellow.command = fake_team(yellow_mode);
  config.teams.blue.name = "Fake B";
  config.teams.blue.command = fake_team(blue_mode);
  config.seed = 7;
  config.half_length = 10;
  return config;
}

}  // namespace fakes

#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "experiments/record/match_config.h"
#include "experiments/schedule/design.h"
#include "experiments/schedule/toml_reader.h"

namespace schedule {

/// A team as a design gives it: a command that exists, or one that has to be built first.
struct Team {
  record::TeamConfig config;
  std::optional<Source> source;
};

/// The whole of a team that `table` describes: a command, or repository, revision, build and run.
/// @throws std::invalid_argument as parse_design
Team read_team(TomlTable& table, std::size_t most_robots);

/// What the table `key` of a condition changes of a team: also `arguments` and `flags`, which are appended to
/// its command. Does nothing when there is no such table.
/// @throws std::invalid_argument as parse_design
void change_team(TomlTable& condition, const std::string& key, Team& team, std::size_t most_robots);

}  // namespace schedule

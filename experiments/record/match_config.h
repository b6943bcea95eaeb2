#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sim/world/robot_id.h"

namespace record {

/// One team of one game: which program plays it, and with which robots.
struct TeamConfig {
  std::string name;                  ///< as tables and the referee message show it
  std::vector<std::string> command;  ///< program and arguments; a bare name is looked up beside `matchday`
  std::vector<int> robots = {0, 1, 2, 3, 4, 5};  ///< numbers of the robots on the field
  double speed_factor = 1;                       ///< of speed and acceleration, in (0, 1]
  std::filesystem::path
      directory{};  ///< where it works, and from where a program with a / is seen; empty: ours
  bool operator==(const TeamConfig&) const = default;
};

/// How real the simulated world is: a preset, and what was changed of it.
struct RealismConfig {
  std::string preset = "measured";        ///< its name
  std::map<std::string, double> changes;  ///< numbers that replace the preset's, by the name of their key
  bool operator==(const RealismConfig&) const = default;
};

/// "measured", or "measured with vision.ball_sigma 0.001"; of more than four changes only how many.
std::string text(const RealismConfig& realism);

/// A game that begins as a recorded one and goes on with live teams.
struct Continuation {
  std::filesystem::path recording;
  /// the first that live teams answer; nothing: the recorded replies to the end, no team is started
  std::optional<std::int64_t> tick;
  bool operator==(const Continuation&) const = default;
};

/// Everything that decides how a game goes, and where its files go.
///
/// The game is a pure function of the builds and of all fields but `recording`, `log` and `directory`.
struct MatchConfig {
  world::PerTeam<TeamConfig> teams;
  std::uint64_t seed = 1;
  std::string rules = "ssl-2015";  ///< name of a rule set
  RealismConfig realism;
  std::optional<double> half_length;  ///< [s] instead of the rule set's
  bool winner = false;                ///< a draw is followed by extra time and a shoot-out
  bool blue_on_positive_half = true;  ///< blue defends the goal at +x in the first half
  world::Team first_kickoff = world::Team::Yellow;
  std::optional<Continuation> continuation;
  std::optional<std::filesystem::path> recording;  ///< where both teams' replies are kept; .gz is packed
  std::optional<std::filesystem::path> log;        ///< the game as a league log, .log or .log.gz
  std::filesystem::path directory;                 ///< where the teams' output goes; empty: nowhere
  bool operator==(const MatchConfig&) const = default;
};

/// The configuration as one line of JSON.
std::string to_json(const MatchConfig& config);

/// @throws std::invalid_argument naming the field when `text` is not such a line
MatchConfig match_config_from_json(const std::string& text);

}  // namespace record

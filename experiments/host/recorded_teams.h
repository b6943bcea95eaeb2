#pragma once

#include <filesystem>
#include <vector>

#include "experiments/record/match_config.h"
#include "sim/wire/match.h"
#include "sim/wire/recording.h"

namespace host {

/// The teams of a recorded game, giving the replies they gave.
class RecordedTeams {
 public:
  /// @param config  of the game that is played with it: its teams' robots
  /// @throws std::runtime_error naming the file when it is no recording, or not one of such teams
  RecordedTeams(const std::filesystem::path& path, const record::MatchConfig& config);

  const wire::proto::TeamHello& hello(world::Team team) const;

  /// The replies to that tick; null when the recording ends before it.
  /// @throws std::runtime_error naming the file when the recording has another tick at this place,
  ///         or teams whose keeper is not on the field
  const wire::proto::Tick* replies(std::int64_t tick);
  /// After the end: the file stops in the middle of a record.
  bool cut() const { return reader_.cut(); }

 private:
  void check(world::Team team, const wire::proto::TeamHello& hello, std::int64_t tick) const;
  std::string name_;
  world::PerTeam<std::vector<int>> robots_;
  wire::RecordingReader reader_;
};

/// The configuration of a recorded game.
/// @throws std::runtime_error naming the file
record::MatchConfig recorded_config(const std::filesystem::path& path);

struct RecordedLength {
  std::int64_t ticks = 0;
  bool cut = false;  ///< the file stops before its end
};

/// How many ticks the recording has; reads and checks all of it.
/// @throws std::runtime_error naming the file
RecordedLength recorded_length(const std::filesystem::path& path);

/// Writes a recording while a game is played.
class Recorder {
 public:
  Recorder(const std::filesystem::path& path, const record::MatchConfig& config,
           const world::PerTeam<wire::proto::TeamHello>& hellos);

  /// The reply to the present tick; call for both teams, then `end_tick`.
  wire::proto::MatchReply& reply(world::Team team);
  /// From the present tick on other teams play.
  void new_teams(const world::PerTeam<wire::proto::TeamHello>& hellos);
  /// @param hash  of the game so far, or empty
  void end_tick(std::int64_t tick, const std::string& hash);
  void close() { writer_.close(); }

 private:
  wire::RecordingWriter writer_;
  wire::proto::Recorded record_;
};

}  // namespace host

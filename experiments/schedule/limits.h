#pragma once

#include <cstdint>

namespace schedule {

/// How much of its own time a team may take [s]: computing, or asleep while the game waits for it.
struct TeamTime {
  double reply = 5;    ///< for one reply
  double second = 20;  ///< for the replies of a simulated second
  double game = 1440;  ///< for those of a game
  bool operator==(const TeamTime&) const = default;
};

/// What is used of it where a design says nothing. Ours: a third of `silence` for a second and two fifths of
/// `game` for a game, at most what stands above: both teams together are then told from a game that is stuck.
constexpr TeamTime usual_team_time(double silence, double game) {
  TeamTime time;
  if (time.second > silence / 3) time.second = silence / 3;
  if (time.game > 0.4 * game) time.game = 0.4 * game;
  if (time.reply > time.second) time.reply = time.second;
  return time;
}

/// What a run may use and how much may go wrong, as the design's [limits] says. None of it is part of a
/// game's result, except that a team above `team_memory` or `team_time` is at fault.
struct Limits {
  // Wall time [s].
  double silence = 60;  ///< of a game without simulated time going on, then it is stuck
  double game = 3600;   ///< of a whole game; usual are 6 to 30 s
  double build = 3600;  ///< of the build command of a team from git
  TeamTime team_time;   ///< keys team_reply, team_second and team_game
  // Sizes [MiB].
  std::int64_t team_memory = 2048;  ///< resident, of all processes of one team
  std::int64_t output = 4;          ///< kept of what one program of one game prints
  std::int64_t kept_logs = 2048;    ///< of all kept games' files; the oldest sampled ones go first
  std::int64_t free_disk = 1024;    ///< below that nothing is started
  // Faults.
  int faults_in_a_row = 5;   ///< void games, then the run stops
  double fault_share = 0.1;  ///< of void attempts among all, after the first 20; then the run stops
  // Evidence, as shares of the games.
  double sampled = 0.01;  ///< whose replies and logs are kept though nothing went wrong
  double audited = 0.01;  ///< played twice to compare their hashes
  bool operator==(const Limits&) const = default;
};

}  // namespace schedule

#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "autoref/referee/referee.h"
#include "experiments/host/budget.h"
#include "experiments/host/stopwatch.h"
#include "experiments/process/isolation.h"
#include "experiments/record/match_config.h"
#include "experiments/record/match_record.h"
#include "sim/engine/engine.h"
#include "sim/world/robot_id.h"
#include "sim/world/time.h"

namespace host {

// Of a team's own time; more ends the game as OverLimit. Ours: a third of the minute after which a runner
// takes a game for stuck, so that two teams fit into it, and two fifths of the hour it gives a game. Over a
// game that is 19 ms a tick: a team that is ready for the league, with 16.7 ms, plays.
inline constexpr std::chrono::milliseconds usual_second{20'000};
inline constexpr std::chrono::milliseconds usual_game{1'440'000};

/// How a game is run, none of which changes what happens in it.
struct Options {
  /// host and teams run on this processor only; -1: wherever the system likes (three times slower)
  int cpu = -1;
  // In the team's own time, see patience.h.
  std::chrono::milliseconds connect_deadline{10'000};  ///< to connect, and then for the hello
  std::chrono::milliseconds reply_deadline{5'000};     ///< for each reply
  /// In a game a team may wait so long for the disk, beside its own time (team_time.h). Ours: with 5 s for a
  /// reply it ends before the 30 s that make a game void.
  std::chrono::milliseconds disk_wait{20'000};
  Budget::Allowed budget{usual_second, usual_game};  ///< for all replies, see budget.h; not in continuations
  std::chrono::milliseconds stop_grace{1'000};       ///< between goodbye or TERM and KILL

  // What a team may use, all its processes together; more ends the game as OverLimit. 0: any amount. Ours:
  // many times what any team of the league needs, and few enough for a machine with several games.
  std::int64_t memory_limit = std::int64_t{2} << 30;  ///< [bytes] resident or in memory files, every 0.1 s
  std::int64_t output_limit = std::int64_t{1} << 30;  ///< [bytes] printed and written
  std::size_t thread_limit = 1000;                    ///< processes and their threads; looked at as memory
  std::size_t kept_output = std::size_t{4} << 20;     ///< [bytes] of what a team prints, in its log

  // What the teams see of the machine; all paths absolute.
  process::Isolation isolation = process::Isolation::None;
  std::vector<std::filesystem::path> hidden;   ///< folders that no isolated team sees: where results are
  std::vector<std::filesystem::path> visible;  ///< what every isolated team sees of home and temporary folder

  bool explain = false;  ///< calls come with their evidence

  /// A game that was none (vitals.h) ends as Implausible, or as StoodStill where one team alone never moved:
  /// for experiments, where it must not count as played.
  bool must_be_plausible = false;
  /// The game is broken off after this tick, as Interrupted.
  std::optional<std::int64_t> last_tick;

  /// Asked once a simulated second and while waiting for a team; true ends the game as Interrupted.
  std::function<bool()> interrupted;
  /// Called with every entry of the timeline as it happens, together with the score after it.
  std::function<void(const record::CallEntry&, const world::PerTeam<int>& score)> on_call;
  /// Called once before the first tick, for those who look on with cameras of their own.
  std::function<void(engine::Engine&)> on_start;
  /// Called in every tick after the referee has seen it, before its wishes are granted.
  std::function<void(const engine::Engine&, const referee::Referee&)> on_tick;
  /// Called once per simulated second.
  std::function<void(world::Time, const world::PerTeam<int>& score)> on_second;
  /// Filled with the time each part of a tick took; null: nothing is measured.
  Stopwatch* stopwatch = nullptr;
};

/// Plays one game in this process, with both teams as child processes, from the first STOP
/// to POST or to a fault.
///
/// The record is complete whatever happens: what a team does wrong is its termination,
/// party at fault and reason, and so is an internal error of ours (HarnessFault). When it returns,
/// no process of the game is left.
///
/// @throws std::invalid_argument when the configuration names an unknown rule set or realism,
///         or has impossible robots; nothing has been started then
/// @throws wire::OutputError when log or recording cannot be made or written; it is removed then
record::MatchRecord play(const record::MatchConfig& config, const Options& options = {});

/// @throws std::invalid_argument naming preset, key or value
void check_realism(const record::RealismConfig& config);

/// The same checks alone.
/// @throws std::invalid_argument naming team, field and value
void check(const record::MatchConfig& config);

}  // namespace host

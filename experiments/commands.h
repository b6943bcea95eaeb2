#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "experiments/bench/bench.h"
#include "experiments/isolation.h"
#include "experiments/live_again.h"
#include "experiments/schedule/limits.h"

// The subcommands of matchday: each takes what the command line said and returns the program's exit code.
//
// Bad input is thrown as std::invalid_argument or std::runtime_error, trouble with a result folder as
// record::StorageError; main() turns them into a sentence and an exit code.
namespace commands {

struct TeamOptions {
  std::string command;  ///< as one line, split as a shell would
  std::string name;     ///< empty: the program's
  std::vector<int> robots = {0, 1, 2, 3, 4, 5};
  double speed_factor = 1;
};

struct RealismOptions {
  std::string preset = "measured";   ///< or a TOML file with a table [realism]
  std::vector<std::string> changes;  ///< as "vision.ball_sigma=0.001"
};

/// What they ask for, checked.
/// @throws std::invalid_argument naming file, line, key and value
record::RealismConfig realism_config(const RealismOptions& options);

/// What of one game is told and kept.
struct OutputOptions {
  std::optional<std::filesystem::path> log;
  std::optional<std::filesystem::path> recording;
  std::filesystem::path team_logs;  ///< folder; empty: none
  bool json = false;                ///< the record instead of the text
  bool explain = false;             ///< after each call its evidence, a line of JSON
};

struct PlayOptions {
  TeamOptions blue;
  TeamOptions yellow;
  std::uint64_t seed = 1;
  std::string rules = "ssl-2015";
  RealismOptions realism;
  std::optional<double> half_length;  ///< [s]
  bool winner = false;
  bool blue_on_negative_half = false;
  bool blue_kicks_off = false;
  IsolationOptions isolation;
  schedule::TeamTime team_time;
  OutputOptions output;
};
/// One game, told as it happens.
int play(const PlayOptions& options);

struct ContinueOptions {
  std::filesystem::path recording;
  std::optional<double> from;  ///< [s] when live teams take over; nothing: the recorded ones play to the end
  std::string blue, yellow;    ///< commands; empty: the recorded ones
  IsolationOptions isolation;
  OutputOptions output;
};
/// A recorded game again, up to a moment or to its end.
int continue_game(const ContinueOptions& options);

struct RunOptions {
  std::filesystem::path design;
  std::filesystem::path out;              ///< empty: results/<name of the design>
  int workers = 0;                        ///< 0: one per processor
  bool preflight = true;                  ///< a short game before the first one
  std::string worker;                     ///< another worker command, for tests; empty: ourselves
  std::optional<int> grown_from{};        ///< pairs of the same experiment in the folder, if they were fewer
  std::string version;                    ///< of matchday
  std::vector<std::string> command_line;  ///< as we were called
};
/// A design, until all its games are in the ledger; then its table.
int run(const RunOptions& options);

struct PlanOptions {
  std::filesystem::path design;
  std::filesystem::path
      from;         ///< a result folder with games of these teams; empty: the design's own, or none
  int workers = 0;  ///< 0: one per processor
};
/// The size of a design, the time it takes here, and what it can show.
int plan(const PlanOptions& options);

struct CompareOptions {
  std::string base;  ///< revision: team B
  std::string next;  ///< revision: team A, which is asked to be better
  std::string repository = ".";
  std::string build;
  std::string run;
  int games = 200;
  std::uint64_t seed = 1;
  std::string rules = "ssl-2015";
  std::string realism = "measured";   ///< a preset
  std::optional<double> half_length;  ///< [s]
  bool sequential = false;            ///< stop as soon as a sequential test has an answer
  double h1 = 0.2;                    ///< of that test, in standard deviations of a game's goal difference
  IsolationOptions isolation;
  RunOptions run_options;  ///< its design is written by compare
};
/// Builds two revisions of a team and lets them play each other: writes a design and runs it.
int compare(const CompareOptions& options);

struct ReportOptions {
  std::filesystem::path folder;
  std::string format = "text";
  bool html = false;                             ///< write report.html in the folder instead of printing
  std::optional<std::filesystem::path> figures;  ///< write the figures as SVG in this folder instead
};
/// The table of a result folder, its page or its figures.
int report(const ReportOptions& options);

struct ReplayOptions {
  std::filesystem::path folder;
  std::string game;
  std::optional<std::filesystem::path> log;
  std::filesystem::path team_logs;
  bool recorded = false;  ///< from the teams' recorded replies, without the teams
  LiveOptions live;
};
/// One game of a ledger again, from its seed or its recorded replies, and whether it went the same.
int replay(const ReplayOptions& options);

struct VerifyOptions {
  std::filesystem::path folder;
  int sample = 3;     ///< games to be played again
  bool json = false;  ///< all of it as JSON at the end
  LiveOptions live;
  std::string version;  ///< of matchday
};
/// Whether a result folder is what was written.
int verify(const VerifyOptions& options);

struct WorkerOptions {
  std::filesystem::path job;
  std::filesystem::path result;
  std::int64_t team_memory = 2048;  ///< [MiB] a team may hold
  std::int64_t output = 4;          ///< [MiB] kept of what a team prints
  IsolationOptions isolation{"none", {}};
  std::vector<std::filesystem::path> hidden;  ///< folders that isolated teams do not see
  schedule::TeamTime team_time;               ///< a team may take
};
/// One game for a runner.
int worker(const WorkerOptions& options);

struct JudgeOptions {
  std::filesystem::path design;
  std::filesystem::path out;              ///< empty: results/judge-<name of the design>
  int games = 0;                          ///< at most so many; 0: all
  int workers = 0;                        ///< 0: one per processor
  std::vector<std::string> shadows;       ///< besides the acting referee and rule set paper
  std::string show;                       ///< GAME:FIRST-LAST: only tell that passage
  double net_speed = 1;                   ///< pace of outside autorefs, in real times
  std::filesystem::path save{};           ///< and write it there as a recorded scenario
  bool sweep = false;                     ///< and those of the sweeps
  std::filesystem::path keep{};           ///< folder in which the games are recorded; empty: nowhere
  std::filesystem::path again{};          ///< folder with recorded games, which are judged instead of played
  std::string version;                    ///< of matchday
  std::vector<std::string> command_line;  ///< as we were called
};
/// Games of a design with shadows looking on, compared with the truth; then the tables.
int judge(const JudgeOptions& options);

struct JudgeGameOptions {
  std::filesystem::path job;
  std::filesystem::path result;
  IsolationOptions isolation{"none", {}};
  std::vector<std::filesystem::path> hidden;  ///< folders that isolated teams do not see
};
/// One game for `judge`.
int judge_game(const JudgeGameOptions& options);

/// A preset as TOML with the meaning, unit and range of every key.
int realism(const RealismOptions& options);

/// The cost table.
int bench(const bench::BenchOptions& options, const RealismOptions& realism, const std::string& isolation);

}  // namespace commands

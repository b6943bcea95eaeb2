#include "experiments/bench/bench.h"

#include <sys/resource.h>

#include <ctime>
#include <filesystem>
#include <optional>
#include <ostream>
#include <stdexcept>

#include "experiments/bench/compare.h"
#include "experiments/bench/scaling.h"
#include "experiments/bench/team_times.h"
#include "experiments/host/play.h"
#include "experiments/host/private_directory.h"
#include "experiments/host/processor.h"
#include "sim/files/regular_file.h"
#include "sim/physics/reference_scene.h"

namespace bench {
namespace {

constexpr std::size_t longest_file = std::size_t{64}
                                     << 20;  // [bytes] ours: figures have some KiB, logs 4 MiB

double processor_seconds() {
  timespec now{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

// Processor time of one tick of the reference scene [s].
double reference_tick() {
  const double begin = processor_seconds();
  const physics::ReferenceResult result = physics::run_reference_scene();
  return (processor_seconds() - begin) / static_cast<double>(result.ticks);
}

// Switches from one process to another so far, ours and of the children we have waited for.
double switches() {
  double sum = 0;
  for (const auto who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage used{};
    ::getrusage(who, &used);
    sum += static_cast<double>(used.ru_nvcsw + used.ru_nivcsw);
  }
  return sum;
}

// Mean from the processor time of the whole process, median and 99 % from what the team says of its ticks.
Row row_of_team(const std::string& part, double mean, const std::filesystem::path& log) {
  Row row{part, mean};
  if (const auto times = team_times(files::text_of(log, longest_file))) {
    row.median = times->median;
    row.ninety_nine = times->ninety_nine;
  }
  return row;
}

std::string read(const std::string& file) {
  try {
    return files::text_of(file, longest_file);
  } catch (const std::runtime_error& error) {
    throw std::invalid_argument("--compare " + std::string(error.what()));
  }
}

}  // namespace

record::MatchConfig standard_game() {
  record::MatchConfig config;
  config.seed = 7;
  for (const world::Team team : world::both_teams) {
    config.teams[team].name = "team-reference";
    config.teams[team].command = {"team-reference"};
  }
  return config;
}

Figures measure(const BenchOptions& options) {
  const host::BoundToProcessor bound(options.cpu);
  Figures figures;
  figures.realism = record::text(options.game.realism);
  const double reference_before = reference_tick();

  host::Stopwatch stopwatch;
  host::Options how;
  how.stopwatch = &stopwatch;
  how.isolation = options.isolation;
  const host::PrivateDirectory logs;
  record::MatchConfig game = options.game;
  if (game.directory.empty()) game.directory = logs.path();
  if (options.team_times) {
    for (const world::Team team : world::both_teams) {
      auto& command = game.teams[team].command;
      command.insert(command.end(), {"--timing", "on"});
    }
  }
  const double switches_before = switches();
  record::MatchRecord record = host::play(game, how);
  if (record.termination != record::Termination::Finished) {
    throw std::runtime_error(std::string("the game did not finish: ") + record.reason);
  }
  figures.reference_tick = (reference_before + reference_tick()) / 2;

  const auto ticks = static_cast<double>(record.ticks);
  figures.ticks = record.ticks;
  figures.switches_per_tick = (switches() - switches_before) / ticks;
  figures.calls_per_tick = static_cast<double>(stopwatch.channel_calls) / ticks;
  figures.hash = record.hash;
  figures.loop_seconds = stopwatch.loop_seconds;
  auto& costs = record.costs;
  const double teams_user = costs["user_seconds_yellow"] + costs["user_seconds_blue"];
  figures.teams_cpu = teams_user + costs["system_seconds_yellow"] + costs["system_seconds_blue"];
  figures.host_cpu = costs["user_seconds_host"] + costs["system_seconds_host"];

  using host::Part;
  for (const Part part : {Part::Physics, Part::Vision, Part::Messages, Part::Referee}) {
    figures.rows.push_back(row_of(name(part), stopwatch.times(part)));
  }
  // The wall time of an exchange holds what the teams compute in it; what they spend in the
  // kernel is the channel's.
  figures.rows.push_back({"channel", stopwatch.mean(Part::Channel) - teams_user / ticks});
  figures.rows.push_back(row_of(name(Part::Bookkeeping), stopwatch.times(Part::Bookkeeping)));
  if (options.game.log) figures.rows.push_back(row_of(name(Part::Log), stopwatch.times(Part::Log)));
  figures.rows.push_back(
      row_of_team("team yellow", costs["user_seconds_yellow"] / ticks, game.directory / "yellow.log"));
  figures.rows.push_back(
      row_of_team("team blue", costs["user_seconds_blue"] / ticks, game.directory / "blue.log"));
  for (const Row& row : figures.rows) figures.sum += row.mean;

  figures.memory_host = static_cast<std::int64_t>(costs["peak_memory_host"]);
  figures.memory_yellow = static_cast<std::int64_t>(costs["peak_memory_yellow"]);
  figures.memory_blue = static_cast<std::int64_t>(costs["peak_memory_blue"]);
  figures.messages_per_tick = static_cast<double>(stopwatch.messages) / ticks;
  figures.bytes_out_per_tick = static_cast<double>(stopwatch.bytes_out) / ticks;
  figures.bytes_in_per_tick = static_cast<double>(stopwatch.bytes_in) / ticks;
  return figures;
}

int bench(const BenchOptions& options, std::ostream& out) {
  std::optional<Figures> before;
  if (!options.compare.empty()) before = figures_from_json(read(options.compare), options.compare);
  const int workers = options.workers < 0 ? static_cast<int>(processors().size()) : options.workers;
  Figures figures = measure(options);
  if (workers > 0) figures.scaling = measure_scaling(options.game, workers);
  out << (options.as_json ? json(figures) : table(figures));
  if (before) out << "\n" << comparison(*before, figures);
  return 0;
}

}  // namespace bench

#include "experiments/runner/run.h"

#include <unistd.h>

#include <algorithm>
#include <iostream>

#include "experiments/commands.h"
#include "experiments/exit_code.h"
#include "experiments/experiment.h"
#include "experiments/record/json_text.h"
#include "experiments/record/ledger.h"
#include "experiments/report/formats.h"
#include "experiments/schedule/command_line.h"
#include "experiments/schedule/schedule.h"
#include "experiments/start.h"
#include "experiments/stopping/wording.h"
#include "sim/wire/match.h"

namespace commands {
namespace {

/// What a stopping rule says at the end, as the exit code.
ExitCode verdict(const Experiment& experiment) {
  if (experiment.design.stopping.rule == schedule::StopRule::Fixed) return done;
  ExitCode code = done;
  for (const stopping::Standing& one : stopping::standings(experiment.design, experiment.attempts)) {
    if (one.decision == stopping::Decision::Undecided) return undecided;
    if (one.decision == stopping::Decision::AcceptH0) code = h0_accepted;
  }
  return code;
}

std::string own_program() { return std::filesystem::read_symlink("/proc/self/exe").string(); }

}  // namespace

int run(const RunOptions& options) {
  check_temporary_folder(Games::OfWorkers);
  schedule::Design design = checked_design(options.design);

  runner::RunOptions settings;
  settings.out = options.out.empty() ? usual_folder(design) : options.out;
  check_result_folder(settings.out, options.design);
  settings.workers = options.workers;
  settings.limits = design.limits;
  settings.preflight = options.preflight;
  const schedule::TeamTime& time = design.limits.team_time;
  settings.worker_command = {own_program(),   "worker",
                             "--team-memory", std::to_string(design.limits.team_memory),
                             "--output",      std::to_string(design.limits.output),
                             "--team-reply",  record::number(std::max(0.001, time.reply)),
                             "--team-second", record::number(time.second),
                             "--team-game",   record::number(time.game)};
  const ChosenIsolation isolation =
      chosen_isolation(design.isolation, options.design.string() + ": isolation =");
  const std::vector<std::string> flags = worker_flags(
      isolation.level, visible_paths(design.visible, options.design.string() + ": visible ="), settings.out);
  settings.worker_command.insert(settings.worker_command.end(), flags.begin(), flags.end());
  settings.isolation = isolation.sentence;
  if (!options.worker.empty()) settings.worker_command = schedule::split_command(options.worker);
  settings.version = options.version;
  settings.grown_from = options.grown_from;
  settings.protocol = "match protocol " + std::to_string(wire::match_protocol_version);
  settings.command_line = options.command_line;
  settings.refresh_command = {own_program(), "report", settings.out.string(), "--html"};
  settings.terminal = ::isatty(STDERR_FILENO) == 1;

  std::cerr << design.name << ": " << schedule::game_count(design) << " games, realism "
            << record::text(design.realism) << ", rule set " << design.rules << ", results in "
            << settings.out.string() << std::endl;
  std::cerr << isolation.sentence << std::endl;
  if (design.stopping.rule != schedule::StopRule::Fixed) {
    std::cerr << "stopping: " << stopping::rule(design) << std::endl;
  }
  build_teams(design, settings.out);
  const std::string again = "continue with: " + schedule::shell_line(options.command_line);
  runner::RunResult result;
  try {
    result = runner::run(design, settings, std::cerr);
  } catch (const record::FolderTaken&) {
    throw;
  } catch (const record::StorageError& error) {
    throw record::StorageError(std::string(error.what()) + "; when it is mended, " + again);
  }
  if (result.ending == runner::Ending::Interrupted) {
    std::cerr << "interrupted, nothing is lost; " << again << std::endl;
    return signal_base + result.signal;
  }
  if (result.ending == runner::Ending::PreflightFailed) return preflight_failed;
  const Experiment experiment = read_experiment(result.out);
  std::cout << report::as_text(summary(experiment));
  if (result.ending == runner::Ending::Done) return verdict(experiment);
  std::cerr << "when it is mended, " << again << std::endl;
  return faults;
}

}  // namespace commands

#include <sched.h>

#include "experiments/commands.h"
#include "experiments/exit_code.h"
#include "experiments/host/play.h"
#include "experiments/one_game.h"
#include "experiments/runner/job_files.h"
#include "experiments/runner/signals.h"

namespace commands {

int worker(const WorkerOptions& options) {
  runner::Signals signals;
  host::Options settings = game_as_told(options.isolation, options.hidden);
  // the one the runner has bound us to; there the game's processes take turns
  settings.cpu = ::sched_getcpu();
  settings.interrupted = [&signals] { return signals.wait(std::chrono::milliseconds{0}).has_value(); };
  settings.memory_limit = options.team_memory << 20;
  settings.kept_output = static_cast<std::size_t>(options.output) << 20;
  set_team_time(options.team_time, settings);
  settings.must_be_plausible = true;
  runner::ProgressWriter progress(runner::progress_file(options.result));
  settings.on_start = [&progress](engine::Engine&) { progress.write(0); };  // both teams have said hello
  settings.on_second = [&progress](world::Time time, const world::PerTeam<int>&) {
    progress.write(world::seconds(time));  // the sign of life that the runner watches
  };
  runner::serve_job(options.job, options.result,
                    [&](const record::MatchConfig& config) { return host::play(config, settings); });
  return done;
}

}  // namespace commands

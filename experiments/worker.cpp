#include <sched.h>

#include <iostream>

#include "experiments/commands.h"
#include "experiments/exit_code.h"
#include "experiments/host/play.h"
#include "experiments/runner/job_files.h"
#include "experiments/runner/signals.h"

namespace commands {

int worker(const WorkerOptions& options) {
  runner::Signals signals;
  host::Options settings;
  settings.cpu =
      ::sched_getcpu();  // the one the runner has bound us to; there the game's processes take turns
  settings.interrupted = [&signals] { return signals.wait(std::chrono::milliseconds{0}).has_value(); };
  // Printing is the sign of life that the runner watches.
  settings.on_second = [](world::Time time, const world::PerTeam<int>& score) {
    std::cout << world::seconds(time) << " s, " << score.yellow << ":" << score.blue << std::endl;
  };
  runner::serve_job(options.job, options.result,
                    [&](const record::MatchConfig& config) { return host::play(config, settings); });
  return done;
}

}  // namespace commands

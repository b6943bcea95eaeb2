#include "experiments/runner/run.h"

#include <sched.h>

#include <algorithm>
#include <memory>
#include <ostream>

#include "experiments/process/program.h"
#include "experiments/record/ledger.h"
#include "experiments/runner/manifest.h"
#include "experiments/runner/plan.h"
#include "experiments/runner/program_files.h"
#include "experiments/runner/progress.h"
#include "experiments/runner/result_folder.h"
#include "experiments/runner/signals.h"
#include "experiments/stopping/watch.h"
#include "experiments/stopping/wording.h"

namespace runner {
namespace {

// How often the workers are looked at: well below the time of a game, and too seldom to disturb it.
constexpr std::chrono::milliseconds look{20};

/// The processors this process may use.
std::vector<int> processors() {
  cpu_set_t set;
  CPU_ZERO(&set);
  ::sched_getaffinity(0, sizeof set, &set);
  std::vector<int> found;
  for (int cpu = 0; cpu < CPU_SETSIZE; ++cpu) {
    if (CPU_ISSET(static_cast<std::size_t>(cpu), &set)) found.push_back(cpu);
  }
  return found;
}

std::string worker_problem(const std::exception& error) {
  return std::string("the worker could not be started: ") + error.what();
}

/// One run from the moment its ledger is open.
class Run {
 public:
  Run(const schedule::Design& design, const RunOptions& options, const ResultFolder& folder,
      record::Ledger& ledger, std::ostream& out)
      : design_(design),
        options_(options),
        folder_(folder),
        ledger_(ledger),
        before_(ledger.attempts()),
        plan_(design, before_),
        watch_(design),
        progress_(out, options.terminal, design, plan_.total(), plan_.resolved()),
        cpus_(processors()),
        workers_(static_cast<std::size_t>(options.workers > 0 ? options.workers
                                                              : static_cast<int>(cpus_.size()))) {
    for (const record::Attempt& attempt : before_) {
      progress_.known(attempt);
      stop_where_answered(attempt);
    }
  }

  RunResult play() {
    announce();
    RunResult result{Ending::Done, 0, folder_.path()};
    while (start_workers() > 0) {
      if (const auto signal = signals_.wait(look)) {
        result = {Ending::Interrupted, *signal, folder_.path()};
        break;
      }
      collect();
      if (faults_in_a_row_ >= options_.most_faults_in_a_row) break;
      progress_.tick(running());
    }
    end_workers();
    progress_.clear();
    if (result.ending == Ending::Done && (plan_.resolved() < plan_.total() || plan_.given_up_pairs() > 0)) {
      result.ending = Ending::TooManyFaults;
    }
    return result;
  }

  const Plan& plan() const { return plan_; }

 private:
  void announce() {
    if (plan_.resolved() == 0) return;
    progress_.say("continuing in " + folder_.path().string() + ": " + std::to_string(plan_.resolved()) +
                  " of " + std::to_string(plan_.total()) + " games are there");
  }

  std::size_t running() const {
    return static_cast<std::size_t>(std::count_if(workers_.begin(), workers_.end(),
                                                  [](const auto& worker) { return worker != nullptr; }));
  }

  /// Fills the free slots; returns how many games are running.
  std::size_t start_workers() {
    for (std::size_t slot = 0; slot < workers_.size(); ++slot) {
      while (!workers_[slot] && faults_in_a_row_ < options_.most_faults_in_a_row) {
        std::optional<Job> job = plan_.next();
        if (!job) break;
        start(slot, *std::move(job));
      }
    }
    return running();
  }

  void start(std::size_t slot, Job job) {
    const std::string id = record::game_id(job.game.key);
    const int cpu = workers_.size() <= cpus_.size() ? cpus_[slot] : cpus_[slot % cpus_.size()];
    record::Attempt failed = attempt_of(job);
    try {
      workers_[slot] =
          std::make_unique<Worker>(options_.worker_command, options_.limits, static_cast<int>(slot), cpu,
                                   std::move(job), folder_.game(id, failed.attempt));
    } catch (const std::runtime_error& error) {
      failed.record.reason = worker_problem(error);
      failed.started = utc_now();
      keep(failed);
    }
  }

  void collect() {
    for (auto& worker : workers_) {
      if (!worker) continue;
      if (const auto attempt = worker->poll()) {
        worker.reset();
        keep(*attempt);
      }
    }
  }

  /// The only place that writes the ledger.
  void keep(const record::Attempt& attempt) {
    ledger_.add(attempt);
    plan_.add(attempt);
    if (attempt.record.at_fault == record::Party::Nobody) folder_.forget_game(record::game_id(attempt.key));
    const bool is_void = record::outcome(attempt.record) == record::Outcome::Void;
    faults_in_a_row_ = is_void ? faults_in_a_row_ + 1 : 0;
    const std::vector<std::size_t> answered = stop_where_answered(attempt);
    progress_.ended(attempt, plan_.resolved());
    for (const std::size_t question : answered) {
      progress_.say(stopping::sentence(watch_.standings()[question], design_));
    }
  }

  /// Games of questions that are answered are not started any more; those that are running end by themselves.
  std::vector<std::size_t> stop_where_answered(const record::Attempt& attempt) {
    if (design_.stopping.rule == schedule::StopRule::Fixed) return {};
    const std::vector<std::size_t> answered = watch_.add(attempt);
    for (const std::size_t question : answered) {
      const stopping::Standing& standing = watch_.standings()[question];
      for (const stopping::Question::Term& term : standing.question.terms) {
        plan_.stop(design_.conditions[term.condition].name, standing.next_pair);
      }
    }
    if (!answered.empty()) progress_.set_total(plan_.total(), plan_.resolved());
    return answered;
  }

  /// Games that are cut short leave no row: they are played again.
  void end_workers() {
    for (auto& worker : workers_) {
      if (worker) worker->ask_to_end();
    }
    for (auto& worker : workers_) {
      if (worker) worker->stop();
      worker.reset();
    }
  }

  const schedule::Design& design_;
  const RunOptions& options_;
  const ResultFolder& folder_;
  record::Ledger& ledger_;
  std::vector<record::Attempt> before_;
  Plan plan_;
  stopping::Watch watch_;
  Progress progress_;
  Signals signals_;
  std::vector<int> cpus_;
  std::vector<std::unique_ptr<Worker>> workers_;  ///< by slot; null: free
  int faults_in_a_row_ = 0;
};

}  // namespace

RunResult run(const schedule::Design& design, const RunOptions& options, std::ostream& progress) {
  std::vector<ProgramFile> files = program_files(design);
  try {
    files.push_back(program_file(process::find_program(options.worker_command.front())));
  } catch (const process::StartError& error) {
    throw std::invalid_argument(worker_problem(error));
  }
  const std::string hash = experiment_hash(design, files, options.protocol);

  const ResultFolder folder(options.out);
  record::Ledger ledger = record::Ledger::open(folder.ledger(), {hash, design.text});
  if (!std::filesystem::exists(folder.manifest())) {
    write_manifest(folder.manifest(),
                   {hash, design, files, options.version, options.protocol, options.command_line});
  }

  Run running(design, options, folder, ledger, progress);
  const RunResult result = running.play();
  if (result.ending == Ending::TooManyFaults) {
    const std::size_t given_up = running.plan().given_up_pairs();
    progress << (running.plan().resolved() < running.plan().total()
                     ? std::to_string(options.most_faults_in_a_row) + " games in a row were void: stopped"
                     : std::to_string(given_up) + " pairs were given up after " +
                           std::to_string(record::max_attempts) + " void attempts each")
             << "; the reasons are in " << folder.ledger().string() << " and the logs in "
             << (folder.path() / "games").string() << std::endl;
  }
  return result;
}

}  // namespace runner

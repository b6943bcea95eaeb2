#include "experiments/runner/run.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <ostream>
#include <set>

#include "experiments/process/family.h"
#include "experiments/process/program.h"
#include "experiments/process/tree.h"
#include "experiments/record/ledger.h"
#include "experiments/runner/archive.h"
#include "experiments/runner/auditor.h"
#include "experiments/runner/breaker.h"
#include "experiments/runner/crew.h"
#include "experiments/runner/evidence.h"
#include "experiments/runner/folder_watch.h"
#include "experiments/runner/ledger_opening.h"
#include "experiments/runner/leftovers.h"
#include "experiments/runner/plan.h"
#include "experiments/runner/preflight.h"
#include "experiments/runner/program_files.h"
#include "experiments/runner/program_watch.h"
#include "experiments/runner/progress.h"
#include "experiments/runner/refresher.h"
#include "experiments/runner/result_folder.h"
#include "experiments/runner/shortage.h"
#include "experiments/runner/signals.h"
#include "experiments/runner/status.h"
#include "experiments/runner/storage.h"
#include "experiments/stopping/watch.h"
#include "experiments/stopping/wording.h"

namespace runner {
namespace {

using Clock = std::chrono::steady_clock;

// How often the workers are looked at: well below the time of a game, and too seldom to disturb it.
constexpr std::chrono::milliseconds look{20};

/// One run from the moment its ledger is open.
class Run {
 public:
  Run(const schedule::Design& design, const RunOptions& options, const ResultFolder& folder,
      record::Ledger& ledger, std::span<const record::Attempt> before, std::span<const ProgramFile> files,
      Signals& signals, std::ostream& out)
      : design_(design),
        options_(options),
        folder_(folder),
        writer_(ledger, options.disk_patience),
        experiment_(ledger.experiment().hash),
        plan_(design, before),
        watch_(design),
        progress_(out, options.terminal, design, plan_.total(), plan_.resolved()),
        breaker_(options.limits, plan_.total()),
        archive_(folder, writer_, options.limits.kept_logs << 20, before),
        programs_(files),
        own_folder_(folder),
        shortage_(options.first_pause, options.disk_patience),
        signals_(signals),
        leftovers_(folder.path()),
        crew_(options.worker_command, worker_limits(options.limits, options.start_up, options.grace),
              options.workers, folder.scratch_note()),
        auditor_(design, folder, ledger, writer_, options.limits.audited, before, crew_.places()),
        storage_(writer_,
                 {folder.path(), options.limits.free_disk << 20, options.free_bytes, options.disk_patience}),
        refresher_(options.refresh_command, options.refresh_interval, folder.path() / "refresh.log") {
    for (const record::Attempt& attempt : before) {
      progress_.known(attempt);
      count(attempt);
      stop_where_answered(attempt);
    }
    status_.experiment = experiment_;
    status_.process = static_cast<int>(::getpid());
    status_.started = options.date();
  }

  RunResult play() {
    RunResult result{Ending::Done, 0, folder_.path()};
    announce();
    if (const auto problem = storage_.look_first()) give_up(*problem);
    if (options_.preflight && plan_.resolved() == 0 && plan_.total() > 0 && !preflight(result)) {
      return finish(result);
    }
    state_ = "running";
    while (start_games() > 0 || must_wait()) {
      if (const auto signal = signals_.wait(look)) {
        if (signal_) break;  // the second
        drain(*signal);
      }
      collect();
      keep_house();
    }
    crew_.end();
    write_last();
    if (signal_) {
      result.ending = Ending::Interrupted;
      result.signal = *signal_;
    } else if (breaker_.tripped() || plan_.given_up_pairs() > 0) {
      result.ending = Ending::TooManyFaults;
    }
    return finish(result);
  }

 private:
  void announce() {
    const std::size_t found = leftovers_.end();
    if (found > 0) {
      progress_.say(processes(found) + " of an earlier run in this folder " + (found == 1 ? "was" : "were") +
                    " still there and had to be ended");
    }
    if (plan_.resolved() == 0) return;
    progress_.say("continuing in " + folder_.path().string() + ": " + std::to_string(plan_.resolved()) +
                  " of " + std::to_string(plan_.total()) + " games are there");
  }

  /// What is still waiting for the ledger gets its last chance.
  void write_last() {
    if (const auto lost = storage_.lost()) progress_.say(*lost);
  }

  /// Ends the run with an error of the storage, leaving everything in order.
  [[noreturn]] void give_up(const std::string& sentence) {
    crew_.end();
    write_last();
    progress_.clear();
    state_ = "storage-trouble";
    status_.reason = sentence;
    write_status();
    throw record::StorageError(sentence);
  }

  // --- games

  bool may_start() const {
    return !signal_ && !breaker_.tripped() && !storage_.waiting() && !shortage_.waiting(Clock::now());
  }

  /// Whether there is something to do, for which disk, ledger or machine have to come back.
  bool must_wait() const {
    const bool idle = breaker_.tripped() || (plan_.idle() && auditor_.idle());
    return !signal_ && (storage_.waiting() || (shortage_.lasts() && !idle));
  }

  /// Fills the free places; returns how many games are running.
  std::size_t start_games() {
    try {
      while (crew_.has_room() && may_start() && (start_audit() || start_game())) {
      }
    } catch (const std::runtime_error& error) {
      if (!is_shortage(error)) throw;
      lack(start_problem(error));
    }
    return crew_.running();
  }

  bool start_audit() {
    if (auditor_.idle()) return false;
    check_files();
    return auditor_.start(crew_, options_.date());
  }

  void lack(const std::string& reason) {
    if (const auto news = shortage_.failed(Clock::now(), reason)) progress_.say(*news);
  }

  bool start_game() {
    std::optional<Job> job = plan_.next();
    if (!job) return false;
    check_files();
    const std::filesystem::path place = folder_.game(record::game_id(job->game.key), job->attempt);
    const bool sampled = is_sampled(job->game.key);
    record::MatchConfig& config = job->game.config;
    // Everything is recorded, since nobody knows beforehand which game will need it; packing is for few.
    if (options_.record) config.recording = place / (sampled ? "game.replies.gz" : "game.replies");
    if (sampled) config.log = place / "game.log.gz";
    record::Attempt failed = attempt_of(*job);
    failed.started = options_.date();
    folder_.check_links(place);
    try {
      crew_.start(Purpose::Schedule, *std::move(job), place, options_.date());
    } catch (const std::runtime_error& error) {
      if (is_shortage(error)) {
        plan_.put_back(failed.key, failed.attempt);
        throw;
      }
      failed.record.reason = start_problem(error);
      keep(failed);
    }
    return true;
  }

  bool is_sampled(const record::GameKey& key) const {
    return sampling_number(experiment_, key) < std::max(options_.limits.sampled, options_.limits.audited);
  }

  void check_folder() {
    if (const auto trouble = own_folder_.trouble()) give_up(*trouble);
  }
  void check_files() {
    check_folder();
    if (const auto changed = programs_.changed()) give_up(sentence(*changed));
  }

  /// Whoever told us to end has told the worker too.
  bool cut_short(const Crew::Ended& ended) const {
    return signal_ && ended.attempt.record.termination == record::Termination::Interrupted;
  }

  void collect() {
    std::vector<Crew::Ended> all = crew_.collect();
    if (!all.empty()) check_files();  // with other ones than ours they may have begun
    for (Crew::Ended& ended : all) {
      strays_ += ended.strays;
      if (ended.strays > 0) {
        progress_.say(record::game_id(ended.attempt.key) + ": " + processes(ended.strays) +
                      " left behind, ended");
      }
      if (ended.purpose == Purpose::Audit) {
        auditor_.ended(ended, cut_short(ended));
      } else if (cut_short(ended)) {
        // No row: played again.
      } else {
        time_left_.add(ended.seconds);
        keep(ended.attempt);
      }
    }
  }

  /// The only place that writes games into the ledger.
  void keep(record::Attempt& attempt) {
    const bool sampled = is_sampled(attempt.key);
    if (const std::string cut = archive_.cut_down(attempt, sampled); !cut.empty()) {
      progress_.say(record::game_id(attempt.key) + ": " + cut);
    }
    const bool too_many = archive_.add(attempt, sampled);
    is_shortage(attempt.record) ? lack(record::game_id(attempt.key) + ": " + attempt.record.reason)
                                : shortage_.over();
    plan_.add(attempt);
    breaker_.add(attempt);
    count(attempt);
    ++status_.played;
    if (too_many && !told_of_evidence_) {
      told_of_evidence_ = true;
      progress_.say("the kept games fill " + mebibytes(options_.limits.kept_logs << 20) +
                    " (limits.kept_logs): from now on the oldest go");
    }
    auditor_.add(attempt);
    const std::vector<std::size_t> answered = stop_where_answered(attempt);
    progress_.left(time_left_.estimate(plan_.total() - plan_.resolved(), crew_.places()));
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
        const std::string& condition = design_.conditions[term.condition].name;
        plan_.stop(condition, standing.next_pair);
        progress_.stop(condition, standing.next_pair);
      }
    }
    if (!answered.empty()) progress_.set_total(plan_.total(), plan_.resolved());
    return answered;
  }

  void count(const record::Attempt& attempt) {
    const bool is_void = record::outcome(attempt.record) == record::Outcome::Void;
    status_.voids += is_void ? 1 : 0;
    status_.forfeits += !is_void && attempt.record.at_fault != record::Party::Nobody ? 1 : 0;
    if (attempt.record.termination == record::Termination::Finished) hashes_.insert(attempt.record.hash);
  }

  // --- before, meanwhile, afterwards

  /// Short games between the programs; false when the night must not begin.
  bool preflight(RunResult& result) {
    state_ = "preflight";
    std::vector<PreflightGame> games = preflight_games(design_);
    progress_.say(
        "first a short game of each two programs, twice, to see that they play (--no-preflight skips it)");
    const auto look_around = [this] {
      keep_house();
      return signals_.wait(look);
    };
    if (const auto signal = play_preflight(games, crew_, folder_, options_.date, look_around)) {
      result.ending = Ending::Interrupted;
      result.signal = *signal;
      return false;
    }
    const PreflightVerdict found = verdict(games, design_, crew_.places());
    for (const std::string& remark : found.remarks) progress_.say(remark);
    if (!found.failure.empty()) {
      result.ending = Ending::PreflightFailed;
      status_.reason = found.failure;
      progress_.say(status_.reason + "; what the programs printed is in " + folder_.preflight().string());
      return false;
    }
    process::remove_tree(folder_.preflight());
    return true;
  }

  void drain(int signal) {
    signal_ = signal;
    state_ = "draining";
    const std::size_t games = crew_.running();
    if (games == 0) return;
    progress_.say("ending: " + std::to_string(games) + (games == 1 ? " game is" : " games are") +
                  " played to the end; the same signal again stops at once");
  }

  void keep_house() {
    const Clock::time_point now = Clock::now();
    progress_.tick(crew_.running());
    if (now - house_kept_ < options_.housekeeping) return;
    house_kept_ = now;
    const auto say = [this](const std::string& sentence) { progress_.say(sentence); };
    check_folder();
    if (const auto problem = storage_.look(now, crew_.running() == 0, say)) give_up(*problem);
    if (const auto problem = shortage_.too_long(now); problem && crew_.running() == 0) give_up(*problem);
    if (const auto complaint = refresher_.look(now)) progress_.say(*complaint);
    std::vector<pid_t> held = crew_.pids();
    if (refresher_.pid() >= 0) held.push_back(refresher_.pid());
    leftovers_.reap(held);
    write_status();
  }

  void write_status() {
    status_.state = state_;
    if (state_ == "running" && storage_.waiting()) status_.state = storage_.state();
    status_.updated = options_.date();
    status_.free_disk = storage_.free();
    status_.seconds = std::chrono::duration<double>(Clock::now() - start_).count();
    status_.games = plan_.total();
    status_.resolved = plan_.resolved();
    status_.given_up_pairs = plan_.given_up_pairs();
    status_.distinct = hashes_.size();
    status_.audited = auditor_.done().size();
    status_.audits_that_differ = auditor_.differing();
    status_.strays = strays_;
    status_.left = time_left_.estimate(plan_.total() - plan_.resolved(), crew_.places());
    status_.memory = process::resident_memory(::getpid());
    status_.open_files = open_files();
    status_.kept_files = archive_.size();
    status_.running = crew_.games();
    runner::write_status(own_folder_.opened() / folder_.status().filename(), status_);
  }

  RunResult finish(RunResult result) {
    progress_.clear();
    if (result.ending == Ending::TooManyFaults) {
      status_.reason = breaker_.tripped()
                           ? *breaker_.tripped() + ": stopped"
                           : std::to_string(plan_.given_up_pairs()) + " pairs were given up after " +
                                 std::to_string(record::max_attempts) + " void attempts each";
      progress_.say(status_.reason + "; the reasons are in " + folder_.ledger().string() +
                    " and the logs in " + (folder_.path() / "games").string());
    }
    if (const std::string waits = breaker_.waits(); !waits.empty()) progress_.say(waits);
    if (const std::size_t found = leftovers_.end(); found > 0) {
      strays_ += found;
      progress_.say(processes(found) + " of the games " + (found == 1 ? "was" : "were") +
                    " still there at the end and had to be ended");
    }
    if (!auditor_.done().empty()) progress_.say(audit_summary(auditor_.done()));
    constexpr std::array states = {"done", "preflight-failed", "too-many-faults", "interrupted"};
    state_ = states.at(static_cast<std::size_t>(result.ending));
    write_status();
    const auto enough = [&] {
      const auto signal = signals_.wait(std::chrono::milliseconds{0});
      if (!signal) return false;
      result.ending = Ending::Interrupted;
      result.signal = *signal;
      return true;
    };
    if (const auto complaint = refresher_.last(enough)) progress_.say(*complaint);
    check_folder();
    return result;
  }

  const schedule::Design& design_;
  const RunOptions& options_;
  const ResultFolder& folder_;
  LedgerWriter writer_;
  std::string experiment_;  ///< its hash
  Plan plan_;
  stopping::Watch watch_;
  Progress progress_;
  Breaker breaker_;
  Archive archive_;
  ProgramWatch programs_;
  FolderWatch own_folder_;
  Shortage shortage_;
  Signals& signals_;
  Leftovers leftovers_;  ///< goes after the crew, whatever happens
  Crew crew_;
  Auditor auditor_;
  Storage storage_;
  Refresher refresher_;
  TimeLeft time_left_;
  Status status_;
  std::string state_ = "starting";
  std::set<std::string> hashes_;  ///< of finished games
  std::size_t strays_ = 0;
  bool told_of_evidence_ = false;
  std::optional<int> signal_;  ///< the first that came
  Clock::time_point start_ = Clock::now();
  Clock::time_point house_kept_{};
};

}  // namespace

RunResult run(const schedule::Design& design, const RunOptions& options, std::ostream& progress) {
  const std::vector<ProgramFile> files = program_files(design, options.worker_command.front());
  const std::string hash = experiment_hash(design, files, options.protocol);

  const ResultFolder folder(options.out);
  Signals signals;
  Opening opening{.remote = options.is_remote(folder.path()), .patience = options.disk_patience};
  if (options.grown_from) {
    schedule::Design before = design;
    before.pairs = *options.grown_from;
    opening.before = experiment_hash(before, files, options.protocol);
  }
  if (opening.remote) {
    progress << folder.path().string()
             << " is on a network file system: who reads the ledger may keep the run waiting" << std::endl;
  }
  RunResult result{Ending::Interrupted, 0, folder.path()};
  std::optional<record::Ledger> ledger = open_ledger(
      folder,
      {hash, design, files, options.version, options.protocol, options.command_line, options.isolation},
      opening, signals, result.signal, progress);
  if (!ledger) return result;
  const std::vector<record::Attempt> before = ledger->attempts(record::Detail::WithoutTimeline);
  result = Run(design, options, folder, *ledger, before, files, signals, progress).play();
  // One that goes on keeps its journal: nobody who reads it meanwhile can make the next run wait.
  if (result.ending != Ending::Interrupted) ledger->put_together();
  return result;
}

}  // namespace runner

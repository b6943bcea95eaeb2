#include <algorithm>
#include <iostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "experiments/builds/builds.h"
#include "experiments/commands.h"
#include "experiments/exit_code.h"
#include "experiments/experiment.h"
#include "experiments/isolation.h"
#include "experiments/one_game.h"
#include "experiments/record/ledger.h"
#include "experiments/runner/audit.h"
#include "experiments/runner/check_files.h"
#include "experiments/runner/evidence.h"
#include "experiments/runner/manifest.h"
#include "experiments/schedule/schedule.h"
#include "sim/console/printable.h"

namespace commands {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_told = 20;  // lines of one kind of damage

/// The findings, printed as they come; remembers whether any is an alarm.
class Findings {
 public:
  void tell(const std::string& what, const std::string& finding) const {
    std::cout << what << std::string(what.size() < 14 ? 14 - what.size() : 1, ' ')
              << console::printable(finding) << std::endl;
  }
  void alarm(const std::string& what, const std::string& finding) {
    alarmed_ = true;
    tell(what, finding);
  }
  void alarms(const std::string& what, const std::vector<std::string>& sentences) {
    for (std::size_t i = 0; i < sentences.size() && i < most_told; ++i) alarm(what, sentences[i]);
    if (sentences.size() > most_told) {
      alarm(what, "and " + std::to_string(sentences.size() - most_told) + " more");
    }
  }
  void rows(const std::string& what, const record::RowCheck& check) {
    std::string text = std::to_string(check.whole) + " as written";
    if (check.unknown > 0) {
      text += ", " + std::to_string(check.unknown) + " not known: without a checksum, by an older matchday";
    }
    if (!check.damaged.empty()) text += ", DAMAGED " + std::to_string(check.damaged.size());
    tell(what, text);
    alarms(what, check.damaged);
  }
  bool alarmed() const { return alarmed_; }

 private:
  bool alarmed_ = false;
};

/// What is the same now as when the folder was made.
struct Builds {
  bool matchday = false;  ///< who plays the games
  bool all = false;       ///< teams too
};

Builds check_manifest(const fs::path& folder, const std::string& experiment, Findings& findings) {
  const fs::path file = folder / "manifest.json";
  Builds builds;
  if (!fs::exists(file)) {
    findings.tell("manifest", "there is none; nobody can say which programs played");
    return builds;
  }
  runner::Origin origin;
  try {
    origin = runner::read_manifest(file);
  } catch (const record::StorageError& error) {
    findings.alarm("manifest", error.what());
    return builds;
  }
  findings.tell("made by", "matchday " + origin.matchday + ", commit " + origin.commit);
  if (origin.experiment_hash != experiment) {
    findings.alarm("manifest",
                   "is of experiment " + origin.experiment_hash + ", the ledger of " + experiment);
  } else if (origin.identity != experiment) {
    findings.alarm("manifest", "design, protocol and programs make experiment " + origin.identity + ", not " +
                                   experiment);
  } else {
    findings.tell("manifest", "design, protocol and programs make experiment " + experiment);
  }
  builds.all = true;
  const fs::path self = fs::read_symlink("/proc/self/exe");
  for (const runner::ProgramFile& one : origin.files) {
    std::string state = "missing";
    try {
      state = runner::program_file(one.path).hash == one.hash ? "same" : "changed since";
    } catch (const std::invalid_argument&) {
    }
    builds.all = builds.all && state == "same";
    builds.matchday = builds.matchday || (state == "same" && one.path == self);
    findings.tell("program", one.path.string() + ": " + state);
  }
  return builds;
}

/// Plays one game again; what follows from it.
void play_again(const fs::path& folder, const Experiment& experiment, const record::Attempt& attempt,
                const Builds& builds, Findings& findings) {
  const std::string id = record::game_id(attempt.key);
  const auto replies = runner::kept_replies(folder / "games" / id / std::to_string(attempt.attempt));
  if (!replies && !builds.all) {
    findings.tell(id, "not played again: its replies were not kept, and a program has changed or is missing");
    return;
  }
  record::MatchConfig config = schedule::find_game(experiment.design, id).config;
  if (replies) config.continuation = record::Continuation{*replies, std::nullopt};
  host::Options settings;
  settings.memory_limit = experiment.design.limits.team_memory << 20;
  if (!replies) {
    settings.isolation = chosen_isolation(experiment.design.isolation, "isolation =").level;
    settings.visible = visible_paths(experiment.design.visible, "visible =");
    settings.hidden = {fs::weakly_canonical(fs::absolute(folder))};
  }
  const OneGame again = play_one_game(config, nullptr, false, settings);
  if (again.signal) throw *again.signal;
  const std::string how = replies ? "from its recorded replies" : "from its seed";
  if (again.record.hash == attempt.record.hash) {
    findings.tell(id, "played again " + how + ": the same hash");
    return;
  }
  std::string told = "played again " + how + ": another hash";
  if (!again.record.reason.empty()) told += " (" + again.record.reason + ")";
  const bool unsteady =
      std::any_of(experiment.audits.begin(), experiment.audits.end(),
                  [](const record::Audit& audit) { return audit.verdict == record::Verdict::TeamDiffers; });
  if (!builds.matchday) {
    findings.tell(id, told + "; matchday is another build than that which played it, so this says nothing");
  } else if (!replies && unsteady) {
    findings.tell(id, told + "; a team is not deterministic, say the audits, so this says nothing");
  } else {
    findings.alarm(id, told);
  }
}

}  // namespace

int verify(const VerifyOptions& options) {
  const fs::path file = options.folder / "ledger.sqlite";
  Findings findings;
  const record::Ledger ledger = record::Ledger::read(file);
  const record::LedgerCheck rows = ledger.check();
  findings.rows("experiment", rows.experiment);
  findings.rows("attempts", rows.attempts);
  findings.rows("audits", rows.audits);
  findings.rows("files' rows", rows.files);
  if (findings.alarmed()) {
    findings.tell("verdict", "DAMAGED; files, programs and games are not looked at with such a ledger");
    return storage;
  }
  Experiment experiment = read_experiment(options.folder);
  const runner::FileCheck files = runner::check_files(options.folder, ledger.files(), experiment.attempts);
  findings.tell("files", std::to_string(files.whole) + " as written, " + std::to_string(files.unknown) +
                             " not known (unfinished games, or an older matchday)");
  findings.alarms("files", files.problems);
  const Builds builds = check_manifest(options.folder, experiment.hash, findings);

  std::vector<const record::Attempt*> finished;
  for (const record::Attempt& attempt : experiment.attempts) {
    if (attempt.record.termination == record::Termination::Finished &&
        attempt.record.at_fault == record::Party::Nobody) {
      finished.push_back(&attempt);
    }
  }
  // The games with the lowest numbers are those whose replies are kept.
  std::stable_sort(finished.begin(), finished.end(), [&](const auto* one, const auto* other) {
    return runner::sampling_number(experiment.hash, one->key) <
           runner::sampling_number(experiment.hash, other->key);
  });
  if (std::cmp_greater(finished.size(), options.sample)) {
    finished.resize(static_cast<std::size_t>(options.sample));
  }
  if (builds.all) builds::prepare(experiment.design, options.folder / "builds", std::cerr);
  try {
    for (const record::Attempt* attempt : finished) {
      play_again(options.folder, experiment, *attempt, builds, findings);
    }
  } catch (const int signal) {
    return signal_base + signal;
  }
  findings.tell("verdict",
                findings.alarmed() ? "NOT what was written" : "all that is known is what was written");
  return findings.alarmed() ? storage : done;
}

}  // namespace commands

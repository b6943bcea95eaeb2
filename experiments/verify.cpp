#include <algorithm>
#include <iostream>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "experiments/commands.h"
#include "experiments/host/recorded_teams.h"
#include "experiments/isolation.h"
#include "experiments/ledger_games.h"
#include "experiments/live_again.h"
#include "experiments/one_game.h"
#include "experiments/record/ledger.h"
#include "experiments/runner/audit.h"
#include "experiments/runner/evidence.h"
#include "experiments/runner/manifest.h"
#include "experiments/runner/program_files.h"
#include "experiments/schedule/schedule.h"
#include "experiments/start.h"
#include "experiments/verification.h"

namespace commands {
namespace {

namespace fs = std::filesystem;

/// A folder that is being verified: what its ledger holds, and what was found.
class Verifier {
 public:
  Verifier(const VerifyOptions& options, std::ostream* out)
      : folder_(options.folder),
        options_(options),
        out_(out),
        ledger_(record::Ledger::read(folder_ / "ledger.sqlite")) {
    all_.folder = folder_.string();
    all_.wanted = options.sample;
  }

  /// @throws the number of a signal that ended a game
  const Verification& verify() {
    check_rows();
    check_manifest();
    play_sample();
    if (out_ != nullptr) tell_verdict(all_, *out_);
    return all_;
  }

 private:
  void check_rows() {
    rows_ = ledger_.check();
    read_design();
    if (design_) compare_with_design(*design_, rows_);
    const auto add = [&](const char* table, const record::RowCheck& check) {
      all_.rows.push_back({table, check.whole, check.unknown, check.damaged});
      if (out_ != nullptr) tell_rows(all_.rows.back(), *out_);
    };
    add("experiment", rows_.experiment);
    add("attempts", rows_.attempts);
    add("audits", rows_.audits);
    add("files", rows_.files);
    const bool all_rows = rows_.files.damaged.empty() && rows_.attempts.damaged.empty();
    all_.files = runner::check_files(folder_, rows_.readable_files, rows_.readable_attempts, all_rows);
    if (out_ != nullptr) tell_files(all_, *out_);
  }

  void read_design() {
    if (!rows_.experiment.damaged.empty()) return;
    const record::Experiment experiment = ledger_.experiment();
    hash_ = experiment.hash;
    try {
      design_ = schedule::parse_design(experiment.design, "its design");
    } catch (const std::invalid_argument& error) {
      no_design_ = error.what();
      all_.unknown_design = "the ledger's design cannot be read: " + no_design_;
    }
  }

  void check_manifest() {
    const fs::path file = folder_ / "manifest.json";
    all_.manifest = fs::exists(file);
    try {
      if (all_.manifest) look_at(runner::read_manifest(file));
    } catch (const record::StorageError& error) {
      all_.manifest_problems.emplace_back(error.what());
    }
    if (out_ != nullptr) tell_manifest(all_, *out_);
  }

  void look_at(const runner::Origin& origin) {
    all_.matchday = origin.matchday;
    all_.commit = origin.commit;
    all_.experiment = origin.identity;
    const auto problem = [&](const std::string& text) { all_.manifest_problems.push_back(text); };
    if (!hash_.empty() && origin.experiment_hash != hash_) {
      problem("is of experiment " + origin.experiment_hash + ", the ledger of " + hash_);
    } else if (origin.identity != origin.experiment_hash) {
      problem("design, protocol and programs make experiment " + origin.identity + ", not " +
              origin.experiment_hash);
    }
    if (origin.ledger_schema > ledger_.version()) {
      problem("the ledger began with schema " + std::to_string(origin.ledger_schema) + " and now says " +
              std::to_string(ledger_.version()));
    }
    compare_designs(origin);
    origin_ = origin;
    const fs::path self = fs::read_symlink("/proc/self/exe");
    for (const runner::ProgramFile& one : origin.files) {
      std::error_code ignored;
      std::string state = fs::exists(one.path, ignored) ? "changed" : "missing";
      try {
        if (runner::program_file(one.path).hash == one.hash) state = "same";
      } catch (const std::invalid_argument&) {  // no file, or it may not be read
      }
      own_build_ = own_build_ || (state == "same" && one.path == self);
      if (state != "same") others_.push_back(one.path.filename().string() + " " + state);
      all_.programs.push_back({one.path.string(), state});
    }
  }

  /// The ledger's design must be that of the manifest.
  void compare_designs(const runner::Origin& origin) {
    if (!design_) return;
    schedule::Design design = *design_;
    runner::take_commits(origin, design);
    const std::string own = schedule::canonical(design);
    if (own == origin.design) return;
    const std::string text = "the ledger's design makes experiment " +
                             runner::experiment_hash(own, origin.files, origin.protocol) + ", not " +
                             origin.experiment_hash;
    // Another version may put the same design into other words.
    if (origin.matchday == options_.version) {
      all_.manifest_problems.push_back(text);
    } else {
      all_.unknown_design = text + ", says another version of matchday than that which wrote it";
    }
  }

  /// Whether a program that the design names is none of those that the manifest names.
  /// @throws std::invalid_argument when one cannot be found
  void check_programs() const {
    for (const runner::ProgramFile& one : runner::program_files(*design_)) {
      const auto same = [&](const runner::ProgramFile& known) { return known.hash == one.hash; };
      if (std::none_of(origin_.files.begin(), origin_.files.end(), same)) {
        throw std::invalid_argument("the design names " + one.path.string() + ", the manifest does not");
      }
    }
  }

  /// Why no game can be played from its seed; empty: they can.
  std::string why_not_from_seed() const {
    if (!all_.manifest || all_.programs.empty()) return "nobody can say which programs played";
    if (others_.empty()) return {};
    constexpr std::size_t most = 3;  // names in a sentence; each program has its own line
    std::string text = "programs are not those that played (";
    for (std::size_t i = 0; i < std::min(others_.size(), most); ++i)
      text += (i == 0 ? "" : ", ") + others_[i];
    if (others_.size() > most) text += ", and " + std::to_string(others_.size() - most) + " more";
    return text + ")";
  }

  /// Finished games, each by its last attempt; those with the lowest numbers first, whose replies are kept.
  std::vector<const record::Attempt*> sample() {
    std::map<record::GameKey, const record::Attempt*> last;
    for (const record::Attempt& attempt : rows_.readable_attempts) {
      if (attempt.record.termination != record::Termination::Finished ||
          attempt.record.at_fault != record::Party::Nobody) {
        continue;
      }
      const record::Attempt*& known = last[attempt.key];
      if (known == nullptr || known->attempt < attempt.attempt) known = &attempt;
    }
    std::vector<std::pair<double, const record::Attempt*>> numbered;
    for (const auto& [key, attempt] : last)
      numbered.push_back({runner::sampling_number(hash_, key), attempt});
    std::stable_sort(numbered.begin(), numbered.end(),
                     [](const auto& one, const auto& other) { return one.first < other.first; });
    all_.finished = numbered.size();
    if (std::cmp_greater(numbered.size(), all_.wanted)) {
      numbered.resize(static_cast<std::size_t>(all_.wanted));
    }
    std::vector<const record::Attempt*> games;
    for (const auto& [number, attempt] : numbered) games.push_back(attempt);
    return games;
  }

  void play_sample() {
    std::string not_from_seed = why_not_from_seed();
    const std::vector<const record::Attempt*> games = sample();
    const bool live = std::any_of(games.begin(), games.end(),
                                  [&](const record::Attempt* attempt) { return !replies_of(*attempt); });
    if (design_ && not_from_seed.empty() && live) {
      try {
        seed_settings_ = live_settings(*design_, folder_, options_.live);
        check_programs();
      } catch (const std::invalid_argument& error) {
        not_from_seed = error.what();
      }
    }
    for (const record::Attempt* attempt : games) {
      all_.games.push_back(again(*attempt, not_from_seed));
      if (out_ != nullptr) tell_game(all_.games.back(), *out_);
    }
  }

  /// How teams see less or more of the machine than in the folder's games; empty: they see the same.
  std::string other_isolation() const {
    const std::string now = process::name(seed_settings_.isolation);
    const std::string before = runner::level_of(origin_.isolation);
    if (!before.empty() && before != now)
      return "with isolation " + now + ", not " + before + " as in the folder";
    const bool narrower = seed_settings_.isolation != process::Isolation::None && !design_->visible.empty() &&
                          seed_settings_.visible.empty();
    return narrower ? "without the files that the folder makes visible (--visible)" : "";
  }

  std::optional<fs::path> replies_of(const record::Attempt& attempt) const {
    return runner::kept_replies(folder_ / "games" / record::game_id(attempt.key) /
                                std::to_string(attempt.attempt));
  }

  GameAgain again(const record::Attempt& attempt, const std::string& not_from_seed) const {
    GameAgain game;
    game.game = record::game_id(attempt.key);
    game.attempt = attempt.attempt;
    const std::optional<fs::path> replies = replies_of(attempt);
    game.from_replies = replies.has_value();
    if (!design_) {
      game.reason = no_design_.empty() ? "the ledger's design is damaged" : no_design_;
      return game;
    }
    if (!replies && !not_from_seed.empty()) {
      game.reason = "its replies were not kept, and " + not_from_seed;
      return game;
    }
    try {
      if (replies) host::recorded_length(*replies);  // all of it is read before any of it is played
    } catch (const std::runtime_error& error) {
      game.reason = std::string("its recording cannot be played: ") + error.what();
      return game;
    }
    try {
      play(attempt, replies, game);
    } catch (const std::invalid_argument& error) {
      game.reason = error.what();
    }
    return game;
  }

  /// @throws std::invalid_argument when the design has no such game
  void play(const record::Attempt& attempt, const std::optional<fs::path>& replies, GameAgain& game) const {
    record::MatchConfig config = schedule::find_game(*design_, game.game).config;
    host::Options settings = replies ? host::Options{} : seed_settings_;
    if (replies) config.continuation = record::Continuation{*replies, std::nullopt};
    settings.memory_limit = design_->limits.team_memory << 20;
    set_team_time(design_->limits.team_time, settings);
    const OneGame played = play_one_game(config, nullptr, false, settings);
    if (played.signal) throw *played.signal;
    if (played.record.hash == attempt.record.hash) {
      game.result = GameAgain::Result::Same;
      return;
    }
    const bool finished = played.record.termination == record::Termination::Finished;
    game.reason = finished ? "another hash" : "it did not come to its end: " + played.record.reason;
    const bool unsteady =
        std::any_of(rows_.readable_audits.begin(), rows_.readable_audits.end(),
                    [](const record::Audit& audit) { return audit.verdict == record::Verdict::TeamDiffers; });
    if (const std::string other = replies ? "" : other_isolation(); !other.empty()) {
      game.reason += ", " + other;
    } else if (!own_build_) {
      game.reason += ", by another build of matchday than that which played it";
    } else if (!replies && unsteady) {
      game.reason += ", and a team is not deterministic, say the audits";
    } else if (!replies && played.record.at_fault == record::Party::Harness) {
      game.reason = "it could not be played: " + played.record.reason;
    } else {
      game.result = GameAgain::Result::Different;
    }
  }

  fs::path folder_;
  VerifyOptions options_;
  std::ostream* out_;  ///< null: nothing is told
  record::Ledger ledger_;
  record::LedgerCheck rows_;
  std::string hash_;  ///< of the experiment; empty when the ledger cannot say it
  std::optional<schedule::Design> design_;
  std::string no_design_;  ///< why it cannot be read
  runner::Origin origin_;  ///< what the manifest says
  host::Options seed_settings_;
  bool own_build_ = false;           ///< this program played the games
  std::vector<std::string> others_;  ///< programs that are not what they were
  Verification all_;
};

}  // namespace

int verify(const VerifyOptions& options) {
  check_temporary_folder(Games::Here);
  asked_isolation(options.live.isolation.level);
  Verifier verifier(options, options.json ? nullptr : &std::cout);
  try {
    const Verification& all = verifier.verify();
    if (options.json) std::cout << to_json(all) << std::flush;
    return exit_code(all);
  } catch (const int signal) {
    return signal_base + signal;
  }
}

}  // namespace commands

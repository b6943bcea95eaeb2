#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <iostream>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "experiments/builds/git.h"
#include "experiments/commands.h"
#include "experiments/host/play.h"
#include "experiments/process/whole_file.h"
#include "experiments/record/json_text.h"
#include "experiments/record/ledger.h"
#include "experiments/runner/result_folder.h"
#include "experiments/schedule/design.h"
#include "experiments/schedule/names.h"
#include "experiments/start.h"

namespace commands {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t digits = 10;  // of a commit in a folder's name

/// A revision as a piece of a file name.
std::string file_word(std::string text) {
  const auto usual = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '_' || c == '.';
  };
  std::replace_if(
      text.begin(), text.end(), [&](char c) { return !usual(c); }, '-');
  return text;
}

/// TOML's basic strings are JSON's.
std::string team_text(const CompareOptions& options, const std::string& letter, const std::string& name,
                      const std::string& commit, const std::string& repository) {
  return fmt::format("\n[teams.{}]\nname = {}\nrepository = {}\nrevision = {}  # {}\nbuild = {}\nrun = {}\n",
                     letter, record::quoted(name), record::quoted(repository), record::quoted(commit), name,
                     record::quoted(options.build), record::quoted(options.run));
}

std::string design_text(const CompareOptions& options, const std::string& name, const std::string& repository,
                        const std::string& base_commit, const std::string& next_commit) {
  std::string text = fmt::format(
      "# Written by `matchday compare`: is {} (team A) better than {} (team B)?\nname = {}\ndescription = "
      "{}\n"
      "seed = {}\ngames = {}\nrealism = {}\n\n[rules]\nset = {}\n",
      options.next, options.base, record::quoted(name),
      record::quoted(fmt::format("{} (A, commit {}) against {} (B, commit {})", options.next,
                                 next_commit.substr(0, digits), options.base, base_commit.substr(0, digits))),
      options.seed, options.games, record::quoted(options.realism), record::quoted(options.rules));
  if (!options.isolation.level.empty()) {
    text.insert(text.find("\n[rules]"), "isolation = " + record::quoted(options.isolation.level) + "\n");
  }
  if (!options.isolation.visible.empty()) {
    std::string paths;
    for (const fs::path& path : visible_paths(options.isolation.visible, "--visible")) {
      paths += (paths.empty() ? "" : ", ") + record::quoted(path.string());
    }
    text.insert(text.find("\n[rules]"), "visible = [" + paths + "]\n");
  }
  if (options.half_length) text += fmt::format("half_length = {}\n", record::number(*options.half_length));
  if (options.sequential) {
    text +=
        fmt::format("\n[stopping]\nrule = \"sequential\"\nmetric = \"goal-difference\"\nh0 = 0\nh1 = {}\n",
                    record::number(options.h1));
  }
  text += team_text(options, "a", options.next, next_commit, repository);
  return text + team_text(options, "b", options.base, base_commit, repository);
}

constexpr const char* games_key = "games = ";

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) {
    if (!line.starts_with('#')) lines.push_back(line);
  }
  return lines;
}

/// What does not change games.
bool is_no_matter(const std::string& line) {
  return line.starts_with("description") || line.starts_with("isolation") || line.starts_with("visible");
}

/// The games a design of ours asks for.
int games_of(const std::vector<std::string>& design) {
  for (const std::string& line : design) {
    if (!line.starts_with(games_key)) continue;
    int games = 0;
    const std::string number = line.substr(std::string(games_key).size());
    std::from_chars(number.data(), number.data() + number.size(), games);
    return games;
  }
  return 0;
}

/// The first line in which two designs of ours differ, but for the number of games; empty: none.
std::string difference(std::vector<std::string> there, std::vector<std::string> here) {
  std::erase_if(there, is_no_matter);
  std::erase_if(here, is_no_matter);
  for (std::size_t i = 0; i < std::max(there.size(), here.size()); ++i) {
    const std::string one = i < there.size() ? there[i] : "nothing";
    const std::string other = i < here.size() ? here[i] : "nothing";
    if (one == other || (one.starts_with(games_key) && other.starts_with(games_key))) continue;
    return "`" + one + "` there, `" + other + "` here";
  }
  return "";
}

void write_design(const fs::path& file, const std::string& text) {
  std::error_code error;
  fs::create_directories(file.parent_path(), error);
  process::write_whole(file, text);
}

/// Throws away what a run left that came to no game. Holds the folder meanwhile:
/// perhaps a run is at its first.
void forget_run(const fs::path& folder) {
  const runner::ResultFolder held(folder);
  for (const char* suffix : {"", "-wal", "-shm", "-journal"}) fs::remove(held.ledger().string() + suffix);
  for (const fs::path& left :
       {held.manifest(), held.status(), held.scratch_note(), held.preflight(), folder / "report.html"})
    fs::remove_all(left);
}

/// Whether the folder may take the comparison: it is new, or without games, or of the same comparison.
///
/// @return  the pairs it was planned with, when it is the same with fewer
/// @throws record::StorageError saying what differs
std::optional<int> settled(const fs::path& folder, const std::string& text, bool sequential) {
  const fs::path file = folder / "ledger.sqlite";
  if (!fs::exists(file)) return std::nullopt;
  record::Experiment stored;
  bool played = false;
  {
    const record::Ledger ledger = record::Ledger::read(file);
    stored = ledger.experiment();
    played = !ledger.attempts(record::Detail::WithoutTimeline).empty();
  }
  if (!played) {
    forget_run(folder);
    return std::nullopt;
  }
  if (stored.design == text) return std::nullopt;
  const std::vector<std::string> there = lines_of(stored.design);
  const std::vector<std::string> here = lines_of(text);
  const auto refuse = [&](const std::string& problem) {
    throw record::FolderTaken(folder.string() + ": " + problem + "; give another --out");
  };
  if (const std::string line = difference(there, here); !line.empty())
    refuse("holds games of another comparison: " + line);
  const int before = games_of(there);
  const int now = games_of(here);
  if (now < before)
    refuse(fmt::format("was begun with --games {}, which cannot be fewer afterwards", before));
  if (now == before) return std::nullopt;  // another description
  if (sequential)
    refuse(
        fmt::format("its sequential test was begun with --games {}, on which its error rates rest", before));
  return before / 2;
}

}  // namespace

int compare(const CompareOptions& options) {
  if (builds::is_remote(options.repository)) {
    throw std::invalid_argument("--team-repo " + options.repository +
                                ": give a clone on this machine; a design file takes addresses too");
  }
  check_temporary_folder(Games::OfWorkers);
  if (options.base.find('\n') != std::string::npos || options.next.find('\n') != std::string::npos) {
    throw std::invalid_argument("a revision must be one line");
  }
  asked_isolation(options.isolation.level);
  if (!std::isfinite(options.h1)) throw std::invalid_argument("--h1: must be a number, as 0.2");
  if (options.seed > std::uint64_t{std::numeric_limits<std::int64_t>::max()}) {
    throw std::invalid_argument("--seed: must be from 0 to 9223372036854775807, the largest number of TOML");
  }
  const std::string base = builds::commit_of(options.repository, options.base, "team B");
  const std::string next = builds::commit_of(options.repository, options.next, "team A");
  const std::string name =
      file_word("compare-" + options.base + "-" + options.next).substr(0, schedule::longest_name);

  RunOptions run_options = options.run_options;
  if (run_options.out.empty()) {
    run_options.out =
        fs::path("results") / (name + "-" + base.substr(0, digits) + "-" + next.substr(0, digits));
  }
  run_options.design = run_options.out / "design.toml";
  const std::string repository = fs::weakly_canonical(options.repository).string();
  const std::string text = design_text(options, name, repository, base, next);
  // Before anything is written: a mistake must not leave a folder of a comparison that cannot be.
  schedule::parse_design(text, "matchday compare (its design)", host::check_realism);
  check_result_folder(run_options.out, run_options.design);
  run_options.grown_from = settled(run_options.out, text, options.sequential);
  write_design(run_options.design, text);
  if (run_options.grown_from) {
    std::cerr << "going on to " << options.games << " games from " << 2 * *run_options.grown_from
              << ": who adds games because of a result gets p values that are too small; a test with "
                 "--sequential may be looked at any time"
              << std::endl;
  }
  if (base == next) {
    std::cerr << "both are commit " << base.substr(0, digits)
              << ": a program against itself, so any difference that shows is chance" << std::endl;
  }
  return run(run_options);
}

}  // namespace commands

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "experiments/builds/git.h"
#include "experiments/commands.h"
#include "experiments/host/play.h"
#include "experiments/record/json_text.h"
#include "experiments/record/ledger.h"
#include "experiments/schedule/design.h"

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
      record::quoted(options.next + " (A) against " + options.base + " (B)"), options.seed, options.games,
      record::quoted(options.realism), record::quoted(options.rules));
  if (options.half_length) text += fmt::format("half_length = {}\n", record::number(*options.half_length));
  if (options.sequential) {
    text +=
        fmt::format("\n[stopping]\nrule = \"sequential\"\nmetric = \"goal-difference\"\nh0 = 0\nh1 = {}\n",
                    record::number(options.h1));
  }
  text += team_text(options, "a", options.next, next_commit, repository);
  return text + team_text(options, "b", options.base, base_commit, repository);
}

/// Writes it where none is. One that is there must be the same, or the folder belongs to another comparison;
/// unless no game was ever begun, as when the build command was wrong.
void write_design(const fs::path& file, const std::string& text) {
  if (std::ifstream there(file); there) {
    std::ostringstream old;
    old << there.rdbuf();
    if (old.str() == text) return;
    if (fs::exists(file.parent_path() / "ledger.sqlite")) {
      throw record::StorageError(file.string() + ": is of another comparison; give another --out");
    }
  }
  std::error_code error;
  fs::create_directories(file.parent_path(), error);
  std::ofstream stream(file, std::ios::trunc);
  stream << text;
  stream.close();
  if (error || !stream) throw record::StorageError(file.string() + ": cannot be written");
}

}  // namespace

int compare(const CompareOptions& options) {
  if (builds::is_remote(options.repository)) {
    throw std::invalid_argument("--team-repo " + options.repository +
                                ": give a clone on this machine; a design file takes addresses too");
  }
  if (options.base.find('\n') != std::string::npos || options.next.find('\n') != std::string::npos) {
    throw std::invalid_argument("a revision must be one line");
  }
  if (!std::isfinite(options.h1)) throw std::invalid_argument("--h1: must be a number, as 0.2");
  if (options.seed > std::uint64_t{std::numeric_limits<std::int64_t>::max()}) {
    throw std::invalid_argument("--seed: must be from 0 to 9223372036854775807, the largest number of TOML");
  }
  const std::string base = builds::commit_of(options.repository, options.base, "team B");
  const std::string next = builds::commit_of(options.repository, options.next, "team A");
  const std::string name = file_word("compare-" + options.base + "-" + options.next);

  RunOptions run_options = options.run_options;
  if (run_options.out.empty()) {
    run_options.out =
        fs::path("results") / (name + "-" + base.substr(0, digits) + "-" + next.substr(0, digits));
  }
  run_options.design = run_options.out / "design.toml";
  const std::string repository = fs::weakly_canonical(options.repository).string();
  const std::string text = design_text(options, name, repository, base, next);
  // Before anything is written: a mistake must not leave a folder of a comparison that cannot be.
  schedule::parse_design(text, "the design of compare", host::check_realism);
  write_design(run_options.design, text);
  return run(run_options);
}

}  // namespace commands

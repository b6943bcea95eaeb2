#include "experiments/builds/builds.h"

#include <xxhash.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <functional>
#include <map>
#include <ostream>
#include <sstream>
#include <stdexcept>

#include "experiments/builds/file_lock.h"
#include "experiments/builds/git.h"
#include "experiments/process/child.h"
#include "experiments/process/family.h"
#include "experiments/process/whole_file.h"
#include "sim/files/regular_file.h"

namespace builds {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t log_limit = std::size_t{64} << 20;  // [bytes] of a build's log
constexpr std::chrono::milliseconds grace{2'000};         // between TERM and KILL
constexpr std::chrono::milliseconds look{100};            // for a signal: at once, for people
constexpr std::size_t tail_lines = 8;                     // of a log in a message
constexpr std::size_t tail_bytes = 1'000;
constexpr std::size_t longest_commits = std::size_t{64} << 20;  // [bytes] ours: a line each

std::string digits_of(const std::string& text) {
  std::array<char, 17> digits{};
  std::snprintf(digits.data(), digits.size(), "%016llx",
                static_cast<unsigned long long>(XXH3_64bits(text.data(), text.size())));
  return std::string(digits.data()).substr(0, 8);
}

using Visit = std::function<void(schedule::Source&, record::TeamConfig&, const std::string& who)>;

void for_each_source(schedule::Design& design, const Visit& visit) {
  for (schedule::Condition& condition : design.conditions) {
    const std::string who = "condition '" + condition.name + "', team ";
    if (condition.a_source) visit(*condition.a_source, condition.a, who + "a");
    if (condition.b_source) visit(*condition.b_source, condition.b, who + "b");
  }
}

/// Where git finds the commits: the repository itself, or our copy of it.
std::string local(const std::string& repository, const fs::path& folder) {
  return is_remote(repository) ? (folder / ("copy-" + digits_of(repository))).string() : repository;
}

/// The last lines of a log, on one line.
std::string tail(const fs::path& log) {
  std::ifstream stream(log);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) {
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    lines.push_back(line);
    if (lines.size() > tail_lines) lines.erase(lines.begin());
  }
  std::string text;
  for (const std::string& line : lines) text += (text.empty() ? "" : " | ") + line;
  if (text.size() > tail_bytes) text = "..." + text.substr(text.size() - tail_bytes);
  return text.empty() ? "it printed nothing" : "it said last: " + text;
}

/// What a reader calls it: the revision, or the team's name where the revision is a commit already.
std::string label(const schedule::Source& source, const record::TeamConfig& team) {
  return (source.revision == source.commit ? team.name : source.revision) + " (commit " +
         source.commit.substr(0, 12) + ")";
}

/// In the environment of everything that a build starts: it is found by it, also in a session of its own.
constexpr const char* mark = "MATCHDAY_BUILD";

std::string entry_of(const fs::path& checkout) { return std::string(mark) + "=" + checkout.string() + "/"; }

/// Runs the build command; nothing is left of it afterwards.
void build(const std::string& build_command, const std::string& what, const fs::path& checkout,
           const fs::path& log, double patience, const std::string& who, const Watch& watch) {
  const auto interruption =
      watch ? watch() : std::function<std::optional<int>()>([] { return std::nullopt; });
  process::Command command;
  command.arguments = {"/bin/sh", "-c", build_command};
  command.environment = {{mark, checkout.string() + "/"}};
  command.directory = checkout;
  command.output = log;
  command.output_limit = log_limit;
  std::string problem;
  std::optional<int> signal;
  {
    process::Child child(command);
    const auto limit =
        std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::duration<double>(patience));
    const auto until = std::chrono::steady_clock::now() + limit;
    bool ended = false;
    while (!ended && !signal && std::chrono::steady_clock::now() < until) {
      ended = child.wait(std::min(look, limit));
      if (!ended) signal = interruption();
    }
    const process::Exit exit = child.stop(grace);
    if (!ended) {
      problem = "took longer than " + std::to_string(limit.count() / 1000) + " s (limits.build)";
    } else if (!exit.clean()) {
      problem = exit.describe();
    }
  }
  process::end_started_with(entry_of(checkout));
  if (signal) throw Interrupted(*signal);
  if (problem.empty()) return;
  throw std::invalid_argument(who + ": the build of " + what + " with '" + build_command + "' " + problem +
                              "; " + tail(log) + "; all of it is in " + log.string());
}

using Revision = std::pair<std::string, std::string>;  // repository and revision

/// The file `commits`: a line each of commit, revision and repository, with tabs between.
std::map<Revision, std::string> read_commits(const fs::path& folder) {
  std::map<Revision, std::string> commits;
  if (!fs::exists(folder / "commits")) return commits;
  std::istringstream stream(files::text_of(folder / "commits", longest_commits));
  std::string commit;
  std::string revision;
  std::string repository;
  while (std::getline(stream, commit, '\t') && std::getline(stream, revision, '\t') &&
         std::getline(stream, repository)) {
    if (!is_commit(commit)) {  // it becomes a folder's name and an argument of git
      throw std::invalid_argument(
          (folder / "commits").string() + ": '" + commit +
          "' is no commit: the file is damaged; remove it, and the revisions are looked "
          "up again");
    }
    commits[{repository, revision}] = commit;
  }
  return commits;
}

void write_commits(const fs::path& folder, const std::map<Revision, std::string>& commits) {
  std::ostringstream stream;
  for (const auto& [revision, commit] : commits) {
    stream << commit << '\t' << revision.second << '\t' << revision.first << '\n';
  }
  process::write_whole(folder / "commits", stream.str());
}

/// A branch that went on is no mistake, but the reader should know which of its commits plays.
void tell_if_moved(const schedule::Source& source, const std::string& commit, const std::string& repository,
                   std::ostream& progress) {
  try {
    const std::string now = commit_of(repository, source.revision, "");
    if (now == commit) return;
    progress << "note: " << source.revision << " has moved to " << now.substr(0, 12)
             << "; this folder stays with " << commit.substr(0, 12) << ", another --out takes the new one"
             << std::endl;
  } catch (const std::invalid_argument&) {  // gone meanwhile: what was built is still there
  }
}

fs::path with(const fs::path& path, const char* ending) { return path.string() + ending; }

/// Makes the build if it is not there; returns whether it was made now.
bool make(const schedule::Source& source, const std::string& what, const std::string& repository,
          const fs::path& checkout, double patience, const std::string& who, std::ostream& progress,
          const Watch& watch) {
  const FileLock lock(with(checkout, ".lock"),
                      [&] { progress << "waiting for another build of " << what << std::endl; });
  const fs::path finished = with(checkout, ".built");
  if (fs::exists(finished) && fs::exists(checkout)) return false;
  progress << "building " << what << " of " << source.repository << " ..." << std::endl;
  fs::remove(finished);
  process::end_started_with(entry_of(checkout));  // of a process that was killed in the middle
  check_out(repository, source.commit, checkout, who);
  const auto start = std::chrono::steady_clock::now();
  if (!source.build.empty()) {
    build(source.build, what, checkout, with(checkout, ".log"), patience, who, watch);
  }
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  std::ostringstream stream;
  stream << "repository " << source.repository << "\nrevision " << source.revision << "\ncommit "
         << source.commit << "\nbuild " << source.build << "\nseconds " << seconds << '\n';
  process::write_whole(finished, stream.str());
  return true;
}

}  // namespace

Interrupted::Interrupted(int number)
    : std::runtime_error("interrupted while a team was built; the same command builds it anew"),
      signal(number) {}

bool any_source(const schedule::Design& design) {
  for (const schedule::Condition& condition : design.conditions) {
    if (condition.a_source || condition.b_source) return true;
  }
  return false;
}

void find_commits(schedule::Design& design, const fs::path& folder, std::ostream& progress) {
  fs::create_directories(folder);
  const FileLock lock(folder / "commits.lock", [] {});
  const std::map<Revision, std::string> pinned = read_commits(folder);
  std::map<Revision, std::string> known;
  for_each_source(design, [&](schedule::Source& source, record::TeamConfig&, const std::string& who) {
    std::string& commit = known[{source.repository, source.revision}];
    if (commit.empty()) {
      const auto before = pinned.find({source.repository, source.revision});
      if (before != pinned.end()) {
        commit = before->second;
        tell_if_moved(source, commit, local(source.repository, folder), progress);
      } else {
        if (is_remote(source.repository)) mirror(source.repository, local(source.repository, folder), who);
        commit = commit_of(local(source.repository, folder), source.revision, who);
      }
    }
    source.commit = commit;
  });
  if (known.size() > pinned.size()) write_commits(folder, known);
}

std::vector<Build> prepare(schedule::Design& design, const fs::path& folder, std::ostream& progress,
                           const Watch& watch) {
  std::vector<Build> builds;
  if (!any_source(design)) return builds;
  find_commits(design, folder, progress);
  const fs::path absolute = fs::canonical(folder);
  std::map<fs::path, bool> done;
  for_each_source(design, [&](schedule::Source& source, record::TeamConfig& team, const std::string& who) {
    const fs::path checkout = absolute / (source.commit + "-" + digits_of(source.build));
    if (!done.contains(checkout)) {
      const bool made = make(source, label(source, team), local(source.repository, folder), checkout,
                             design.limits.build, who, progress, watch);
      builds.push_back(
          {team.name, source.repository, source.revision, source.commit, source.build, checkout, made});
      done[checkout] = true;
    }
    team.directory = checkout;
  });
  return builds;
}

}  // namespace builds

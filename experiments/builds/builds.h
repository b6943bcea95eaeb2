#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <iosfwd>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "experiments/schedule/design.h"

namespace builds {

/// One checkout that was built.
struct Build {
  std::string team;  ///< as the tables call the first team that uses it
  std::string repository;
  std::string revision;
  std::string commit;              ///< 40 hexadecimal digits
  std::string command;             ///< that built it
  std::filesystem::path checkout;  ///< absolute
  bool made_now = false;           ///< by this call; otherwise found
};

/// Somebody wants us to end while a build runs.
struct Interrupted : std::runtime_error {
  explicit Interrupted(int number);
  int signal;  ///< its number
};

/// Holds signals back while a build runs, from the call until the function it returns is gone; that one says
/// the number of the signal that has come, if any.
using Watch = std::function<std::function<std::optional<int>()>()>;

/// Looks up the commits of all teams that come from git, and writes them into the design; builds nothing.
///
/// The file `commits` in the folder keeps what was found: a result folder stays with the commits it began
/// with, wherever their branches go.
///
/// @param folder  of the builds, also for copies of repositories that are not on this machine
/// @param progress  told when a branch has moved since
/// @throws std::invalid_argument naming condition, team, repository and revision
void find_commits(schedule::Design& design, const std::filesystem::path& folder, std::ostream& progress);

/// Builds every team of the design that comes from git, each commit once, and lets the teams start there.
///
/// A build is a git worktree `folder`/<commit>-<digits of the build command>, in which a shell has run the
/// build command; beside it its log. Whoever finds a finished one uses it; one that was cut short is made
/// anew; a second process waits for the first. A build and all that it has started end with the call, however
/// it ends; what a killed process left of one is ended before it is made anew.
///
/// @param folder  <result folder>/builds
/// @param progress  told what is built
/// @return  what is there now, in the design's order
/// @throws std::invalid_argument in one sentence, with the end of the build's log when that went wrong
/// @throws Interrupted when `watch` says so; the build that ran is made anew by the next call
std::vector<Build> prepare(schedule::Design& design, const std::filesystem::path& folder,
                           std::ostream& progress, const Watch& watch = {});

/// Whether any team comes from git.
bool any_source(const schedule::Design& design);

}  // namespace builds

#include "experiments/start.h"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string_view>
#include <system_error>

#include "experiments/builds/builds.h"
#include "experiments/host/play.h"
#include "experiments/isolation.h"
#include "experiments/record/ledger.h"
#include "experiments/runner/program_files.h"
#include "experiments/runner/signals.h"
#include "experiments/schedule/schedule.h"
#include "sim/console/printable.h"

namespace commands {

schedule::Design checked_design(const std::filesystem::path& file) {
  schedule::Design design = schedule::read_design(file, host::check_realism);
  for (std::size_t i = 0; i < design.conditions.size(); ++i) {
    const schedule::Condition& condition = design.conditions[i];
    const std::string who = file.string() + ": condition '" + condition.name + "', team ";
    if (!condition.a_source) runner::team_files(condition.a, who + "a");
    if (!condition.b_source) runner::team_files(condition.b, who + "b");
    host::check(schedule::game(design, 2 * i).config);
  }
  visible_paths(design.visible, file.string() + ": visible =");
  return design;
}

void build_teams(schedule::Design& design, const std::filesystem::path& result_folder) {
  const std::filesystem::path builds = result_folder / "builds";
  std::error_code ignored;
  if (std::filesystem::is_symlink(builds, ignored)) {
    throw record::StorageError(builds.string() +
                               ": is a link, and a run writes into its own folder only; remove it, or give "
                               "another --out");
  }
  builds::prepare(design, builds, std::cerr, [] {
    return [signals = std::make_shared<runner::Signals>()] {
      return signals->wait(std::chrono::milliseconds{0});
    };
  });
}

std::filesystem::path usual_folder(const schedule::Design& design) {
  return std::filesystem::path("results") / design.name;
}

void make_folder(const std::filesystem::path& folder, const std::string& flag) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (!error) return;
  throw std::invalid_argument(flag + " " + folder.string() +
                              ": the folder cannot be made: " + error.message());
}

void check_result_folder(const std::filesystem::path& folder, const std::filesystem::path& design) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored) || fs::exists(folder / "ledger.sqlite", ignored)) return;
  // What a run that did not come to its ledger leaves behind.
  constexpr std::array ours{"design.toml", "builds"};
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
    const std::string name = entry.path().filename().string();
    if (std::find(ours.begin(), ours.end(), name) != ours.end()) continue;
    const fs::path kind = entry.path().extension();
    if (kind == ".log" || kind == ".csv") continue;  // of whoever watches the run
    if (fs::equivalent(entry.path(), design, ignored)) continue;
    throw record::StorageError("--out " + folder.string() + ": holds '" + name +
                               "' and no results; give a new folder, so that results do not mix with other "
                               "things");
  }
}

void check_temporary_folder(Games games) {
  // Their names: host::PrivateDirectory, host::TeamProcess, runner::Scratch.
  constexpr std::string_view own = "/matchday-XXXXXX/socket";
  constexpr std::string_view of_worker = "/matchday-run-XXXXXX/1023";
  constexpr std::size_t longest_socket = sizeof(sockaddr_un::sun_path) - 1;
  std::error_code error;
  const std::filesystem::path folder = std::filesystem::temp_directory_path(error);
  if (error || ::access(folder.c_str(), W_OK | X_OK) != 0) {
    const char* name = std::getenv("TMPDIR");
    throw std::invalid_argument("TMPDIR " +
                                console::shortened(console::printable(name != nullptr ? name : "/tmp"), 200) +
                                ": is no folder in which files can be made; give it another value");
  }
  const std::size_t most =
      longest_socket - own.size() - (games == Games::OfWorkers ? of_worker.size() : std::size_t{0});
  const std::string path = folder.string();
  if (path.size() <= most) return;
  throw std::invalid_argument("TMPDIR " + console::shortened(console::printable(path), 200) + ": has " +
                              std::to_string(path.size()) + " bytes and may have " + std::to_string(most) +
                              ", since the teams' sockets are made in it, whose paths have at most " +
                              std::to_string(longest_socket) + "; give it a shorter value");
}

}  // namespace commands

#include "experiments/start.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <system_error>

#include "experiments/host/play.h"
#include "experiments/record/ledger.h"
#include "experiments/runner/program_files.h"
#include "experiments/schedule/schedule.h"

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
  return design;
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

}  // namespace commands

#include "experiments/output_file.h"

#include <stdexcept>
#include <system_error>

#include "experiments/start.h"

namespace commands {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void reject(const std::string& flag, const fs::path& path, const std::string& problem) {
  throw std::invalid_argument(flag + " " + path.string() + ": " + problem);
}

/// Where a path leads, links followed as far as there is something.
fs::path target(const fs::path& path) {
  std::error_code error;
  const fs::path absolute = fs::absolute(path, error);
  const fs::path real = fs::weakly_canonical(absolute, error);
  return error ? absolute : real;
}

/// What is in a result folder has its checksum in the ledger, and would not be what was written any more.
void reject_results(const std::string& flag, const fs::path& path) {
  const fs::path real = target(path);
  for (fs::path folder = real; folder.has_relative_path(); folder = folder.parent_path()) {
    std::error_code ignored;
    if (!fs::exists(folder / "ledger.sqlite", ignored)) continue;
    reject(flag, path,
           "is in the result folder " + folder.string() + ", where only its run writes; give another place");
  }
}

}  // namespace

void check_output(const std::string& flag, const std::optional<fs::path>& file, const std::string& ending) {
  if (!file) return;
  std::error_code ignored;
  if (fs::is_directory(*file, ignored)) reject(flag, *file, "is a folder; give the name of a file");
  for (const fs::path& path : {*file, target(*file)}) {
    if (path != *file && fs::is_character_file(path, ignored)) continue;  // /dev/null has nothing to lose
    const std::string name = path.filename().string();
    if (name.ends_with(ending) || name.ends_with(ending + ".gz")) continue;
    reject(flag, *file,
           (path == *file ? "must end in " : "is a link to " + path.string() + ", which must end in ") +
               ending + " or " + ending + ".gz");
  }
  const fs::path folder = file->has_parent_path() ? file->parent_path() : ".";
  if (!fs::is_directory(folder, ignored)) {
    reject(flag, *file, "there is no folder " + folder.string() + "; make it first");
  }
  reject_results(flag, *file);
}

void make_team_logs(const fs::path& folder) {
  if (folder.empty()) return;
  const std::string flag = "--team-logs";
  reject_results(flag, folder);
  make_folder(folder, flag);
}

}  // namespace commands

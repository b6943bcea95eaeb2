#include "experiments/runner/folder_watch.h"

#include <unistd.h>

#include <array>
#include <cstdlib>
#include <system_error>

namespace runner {
namespace {

namespace fs = std::filesystem;

bool is_same(const struct stat& one, const struct stat& other) {
  return one.st_dev == other.st_dev && one.st_ino == other.st_ino;
}

bool is_there(const fs::path& path, const struct stat& opened) {
  struct stat now {};
  return ::lstat(path.c_str(), &now) == 0 && is_same(now, opened);
}

bool has_name(const fs::path& path) {
  struct stat now {};
  return ::lstat(path.c_str(), &now) == 0;
}

/// What an open file is called now; nothing when it has no name any more.
std::optional<fs::path> name_of(const fs::path& descriptor, const struct stat& opened) {
  std::error_code error;
  const fs::path name = fs::read_symlink(descriptor, error);
  if (error || !is_there(name, opened)) return std::nullopt;
  return name;
}

/// The same of one of ours, found by what it is.
std::optional<fs::path> name_of(const struct stat& opened) {
  std::error_code error;
  for (fs::directory_iterator entry("/proc/self/fd", error), end; !error && entry != end;
       entry.increment(error)) {
    const int number = std::atoi(entry->path().filename().c_str());
    struct stat status {};
    if (::fstat(number, &status) == 0 && is_same(status, opened)) return name_of(entry->path(), opened);
  }
  return std::nullopt;
}

}  // namespace

FolderWatch::FolderWatch(const ResultFolder& folder) : folder_(folder) {
  for (const char* ending : {"", "-wal", "-shm"}) {
    File file{folder.ledger().string() + ending};
    if (::lstat(file.path.c_str(), &file.seen) == 0) files_.push_back(std::move(file));
  }
}

fs::path FolderWatch::opened() const { return "/proc/self/fd/" + std::to_string(folder_.descriptor()); }

std::string FolderWatch::folder_trouble() const {
  struct stat opened_folder {};
  if (::fstat(folder_.descriptor(), &opened_folder) != 0 || is_there(folder_.path(), opened_folder))
    return {};
  const std::string other = has_name(folder_.path()) ? ", and something else has its name" : "";
  const std::string what = "result folder " + folder_.path().string() + " was ";
  if (const auto name = name_of(opened(), opened_folder)) {
    return what + "renamed while the experiment ran" + other + ": its games are in " + name->string() +
           "; give it its name again, or go on with --out " + name->string();
  }
  return what + "removed while the experiment ran" + other +
         ": its games are lost; start again, or give another --out";
}

std::optional<std::string> FolderWatch::trouble() const {
  if (const std::string found = folder_trouble(); !found.empty()) return found;
  for (const File& file : files_) {
    if (is_there(file.path, file.seen)) continue;
    const bool ledger = file.path == folder_.ledger();
    const std::string other = has_name(file.path) ? ", and another file has its name" : "";
    const std::string what = file.path.string() + " was ";
    if (const auto name = name_of(file.seen)) {
      return what + "renamed while the experiment ran" + other + ": " +
             (ledger ? "the games are in " : "the last games are in ") + name->string() +
             "; give it its name again and start again";
    }
    return what + "removed while the experiment ran" + other + ": " +
           (ledger ? "the games that it held are lost; start again, and they are played again, or give "
                     "another --out"
                   : "the last games may be lost; start again, and they are played again");
  }
  return std::nullopt;
}

}  // namespace runner

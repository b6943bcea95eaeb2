#include "experiments/host/private_directory.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <ctime>
#include <stdexcept>
#include <string>
#include <system_error>

#include "experiments/process/tree.h"

namespace host {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view prefix = "matchday-";
constexpr std::size_t random_letters = 6;  // of mkdtemp
// Ours: between the making of a directory and its lock lie microseconds; builds that knew no lock
// need theirs no longer.
constexpr std::time_t youngest = 3600;  // [s]

bool is_named_as_ours(const std::string& name) {
  return name.size() == prefix.size() + random_letters && name.starts_with(prefix) &&
         name.find('-', prefix.size()) == std::string::npos;
}

/// Locked as long as this process lives; -1 when another one holds it, or it is no directory.
int locked(const fs::path& path) {
  const int file = ::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  if (file < 0) return -1;
  if (::flock(file, LOCK_EX | LOCK_NB) == 0) return file;
  ::close(file);
  return -1;
}

/// Of a program that was killed: ours by name and owner, not new, and nobody holds it.
void remove_if_left(const fs::path& path) {
  struct stat info {};
  if (::lstat(path.c_str(), &info) != 0 || !S_ISDIR(info.st_mode) || info.st_uid != ::geteuid()) return;
  if (std::time(nullptr) - info.st_mtime < youngest) return;
  const int lock = locked(path);
  if (lock < 0) return;
  process::remove_tree(path);
  ::close(lock);
}

void remove_left(const fs::path& folder) {
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    if (is_named_as_ours(entry->path().filename().string())) remove_if_left(entry->path());
  }
}

}  // namespace

PrivateDirectory::PrivateDirectory() {
  const fs::path folder = fs::temp_directory_path();
  remove_left(folder);
  std::string name = (folder / (std::string(prefix) + std::string(random_letters, 'X'))).string();
  if (::mkdtemp(name.data()) == nullptr) {  // makes it with mode 0700
    throw std::runtime_error("cannot make the directory " + name + ": " +
                             std::generic_category().message(errno));
  }
  path_ = name;
  lock_ = locked(path_);  // where it cannot be locked, nobody else can either, and it is left alone
}

PrivateDirectory::~PrivateDirectory() {
  process::remove_tree(path_);
  if (lock_ >= 0) ::close(lock_);
}

}  // namespace host

#include "experiments/process/tree.h"

#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace process {
namespace {

constexpr int block = 512;                  // [bytes] of st_blocks, stat(2)
constexpr int most_tries = 1000;            // for a free name
constexpr std::size_t at_a_time = 100'000;  // names of one folder in memory

/// A folder below another, never through a link; its owner's rights are given back when they were taken away.
int open_folder(int parent, const char* name) {
  constexpr int flags = O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC;
  const int file = ::openat(parent, name, flags);
  if (file >= 0) return file;
  const int place = ::openat(parent, name, O_PATH | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  if (place < 0) return -1;
  ::chmod(("/proc/self/fd/" + std::to_string(place)).c_str(), S_IRWXU);
  ::close(place);
  return ::openat(parent, name, flags);
}

/// The first names in an open folder.
std::vector<std::string> names_in(int folder, std::size_t most) {
  struct Close {
    void operator()(DIR* directory) const { ::closedir(directory); }
  };
  std::vector<std::string> names;
  const int copy = ::openat(folder, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);  // read from the start
  if (copy < 0) return names;
  const std::unique_ptr<DIR, Close> directory(::fdopendir(copy));
  if (!directory) {
    ::close(copy);
    return names;
  }
  while (names.size() < most) {
    const dirent* entry = ::readdir(directory.get());
    if (entry == nullptr) break;
    const std::string_view name = entry->d_name;
    if (name != "." && name != "..") names.emplace_back(name);
  }
  return names;
}

void add_size(int folder, int depth, const TreeBounds& bounds, TreeSize& sum) {
  for (const std::string& name : names_in(folder, bounds.entries + 1)) {
    if (++sum.entries > bounds.entries) {
      sum.whole = false;
      return;
    }
    struct stat status {};
    if (::fstatat(folder, name.c_str(), &status, AT_SYMLINK_NOFOLLOW) != 0) continue;
    if (S_ISREG(status.st_mode)) {
      sum.bytes += std::int64_t{status.st_blocks} * block;  // not st_size: neither holes nor room set aside
      sum.length +=
          std::min<std::int64_t>(status.st_size, std::numeric_limits<std::int64_t>::max() - sum.length);
    }
    if (!S_ISDIR(status.st_mode)) continue;
    if (depth >= bounds.depth) {
      sum.whole = false;
      continue;
    }
    const int below = open_folder(folder, name.c_str());
    if (below < 0) continue;
    add_size(below, depth + 1, bounds, sum);
    ::close(below);
    if (sum.entries > bounds.entries) return;
  }
}

/// Moves a folder up, where it gets a name that nobody has.
bool move_up(int from, const char* name, int top, std::size_t& counter) {
  for (int attempt = 0; attempt < most_tries; ++attempt) {
    const std::string free = ".matchday-" + std::to_string(++counter);
    if (::renameat2(from, name, top, free.c_str(), RENAME_NOREPLACE) == 0) return true;
  }
  return false;
}

/// Empties an open folder: what is in a folder of it is moved up into it first, so that no path gets long.
void empty(int top) {
  std::size_t counter = 0;
  for (bool progress = true; progress;) {
    progress = false;
    for (const std::string& name : names_in(top, at_a_time)) {
      if (::unlinkat(top, name.c_str(), 0) == 0 || ::unlinkat(top, name.c_str(), AT_REMOVEDIR) == 0) {
        progress = true;
        continue;
      }
      const int folder = open_folder(top, name.c_str());
      if (folder < 0) continue;
      ::fchmod(folder, S_IRWXU);
      for (const std::string& inner : names_in(folder, at_a_time)) {
        if (::unlinkat(folder, inner.c_str(), 0) == 0 ||
            ::unlinkat(folder, inner.c_str(), AT_REMOVEDIR) == 0) {
          progress = true;
          continue;
        }
        // To move a folder its own ".." is written.
        if (const int opened = open_folder(folder, inner.c_str()); opened >= 0) {
          ::fchmod(opened, S_IRWXU);
          ::close(opened);
        }
        progress = move_up(folder, inner.c_str(), top, counter) || progress;
      }
      ::close(folder);
      progress = ::unlinkat(top, name.c_str(), AT_REMOVEDIR) == 0 || progress;
    }
  }
}

}  // namespace

TreeSize tree_size(const std::filesystem::path& folder, const TreeBounds& bounds) {
  TreeSize sum;
  const int top = open_folder(AT_FDCWD, folder.c_str());
  if (top < 0) return sum;
  add_size(top, 1, bounds, sum);
  ::close(top);
  return sum;
}

void remove_tree(const std::filesystem::path& path) {
  if (::unlinkat(AT_FDCWD, path.c_str(), 0) == 0) return;
  const int top = open_folder(AT_FDCWD, path.c_str());
  if (top < 0) return;
  ::fchmod(top, S_IRWXU);
  empty(top);
  ::close(top);
  ::unlinkat(AT_FDCWD, path.c_str(), AT_REMOVEDIR);
}

}  // namespace process

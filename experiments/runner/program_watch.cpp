#include "experiments/runner/program_watch.h"

#include <stdexcept>

namespace runner {
namespace {

bool alike(const struct stat& one, const struct stat& other) {
  const auto same = [](const timespec& a, const timespec& b) {
    return a.tv_sec == b.tv_sec && a.tv_nsec == b.tv_nsec;
  };
  return one.st_dev == other.st_dev && one.st_ino == other.st_ino && one.st_size == other.st_size &&
         same(one.st_mtim, other.st_mtim) && same(one.st_ctim, other.st_ctim);
}

}  // namespace

ProgramWatch::ProgramWatch(std::span<const ProgramFile> files) {
  for (const ProgramFile& file : files) entries_.push_back({file});  // looked at once by the first changed()
}

std::optional<std::filesystem::path> ProgramWatch::changed() {
  for (Entry& entry : entries_) {
    struct stat now {};
    if (::stat(entry.file.path.c_str(), &now) != 0) return entry.file.path;
    if (alike(now, entry.seen)) continue;
    try {
      if (program_file(entry.file.path).hash != entry.file.hash) return entry.file.path;
    } catch (const std::invalid_argument&) {
      return entry.file.path;
    }
    entry.seen = now;
  }
  return std::nullopt;
}

}  // namespace runner

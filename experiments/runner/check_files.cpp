#include "experiments/runner/check_files.h"

#include <algorithm>
#include <set>

#include "experiments/record/checksum.h"
#include "experiments/runner/evidence.h"

namespace runner {
namespace {

namespace fs = std::filesystem;

/// "games/equal-0003-1/1" of a file below it; empty for others.
std::string place_of(const fs::path& file) {
  auto part = file.begin();
  fs::path place;
  for (int i = 0; i < 3; ++i, ++part) {
    if (part == file.end()) return {};
    place /= *part;
  }
  return place.generic_string();
}

/// A name in the ledger that leads out of the result folder.
bool leaves(const fs::path& file) {
  return file.empty() || file.is_absolute() || std::find(file.begin(), file.end(), "..") != file.end();
}

/// What stands where a file was written, or is missing there; empty: a file.
std::string no_file(const fs::path& path) {
  std::error_code ignored;
  const fs::file_status status = fs::symlink_status(path, ignored);
  if (fs::is_symlink(status)) return " is a link, a file was written";
  if (!fs::is_regular_file(status)) return fs::exists(status) ? " is no file any more" : " is missing";
  return {};
}

}  // namespace

FileCheck check_files(const fs::path& root, std::span<const record::KeptFile> known,
                      std::span<const record::Attempt> attempts, bool all_rows) {
  FileCheck check;
  std::set<std::string> named;
  std::set<std::string> kept_places;
  for (const record::KeptFile& file : known) {
    named.insert(file.path);
    kept_places.insert(place_of(file.path));
    const std::string other =
        leaves(file.path) ? " is a name outside of the folder" : no_file(root / file.path);
    if (!other.empty()) {
      check.problems.push_back(file.path + other);
      continue;
    }
    std::error_code error;
    const auto size = fs::file_size(root / file.path, error);
    try {
      if (static_cast<std::int64_t>(size) != file.size) {
        check.problems.push_back(file.path + " has " + std::to_string(size) + " bytes, it was written with " +
                                 std::to_string(file.size));
      } else if (record::checksum_of_file(root / file.path, file.size) != file.checksum) {
        check.problems.push_back(file.path + " is not what was written");
      } else {
        ++check.whole;
      }
    } catch (const std::runtime_error& problem) {
      check.problems.push_back(problem.what());
    }
  }
  std::set<std::string> played;
  for (const record::Attempt& attempt : attempts) {
    played.insert("games/" + record::game_id(attempt.key) + "/" + std::to_string(attempt.attempt));
  }
  std::error_code error;
  for (fs::recursive_directory_iterator entry(root / "games", error), end; !error && entry != end;
       entry.increment(error)) {
    std::error_code ignored;
    const fs::file_type kind = entry->symlink_status(ignored).type();
    if (kind == fs::file_type::directory) continue;
    const std::string path = entry->path().lexically_relative(root).generic_string();
    if (named.contains(path)) continue;
    const std::string place = place_of(path);
    if (kept_places.contains(place) && played.contains(place)) {
      check.problems.push_back(path + (all_rows ? " was added" : " was added, or its row is damaged"));
    } else {
      ++check.unknown;
    }
  }
  return check;
}

}  // namespace runner

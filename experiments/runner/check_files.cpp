#include "experiments/runner/check_files.h"

#include <map>
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

}  // namespace

FileCheck check_files(const fs::path& root, std::span<const record::KeptFile> known,
                      std::span<const record::Attempt> attempts, bool all_rows) {
  FileCheck check;
  std::set<std::string> named;
  std::set<std::string> kept_places;
  for (const record::KeptFile& file : known) {
    named.insert(file.path);
    kept_places.insert(place_of(file.path));
    std::error_code error;
    const auto size = fs::file_size(root / file.path, error);
    if (error) {
      check.problems.push_back(file.path + " is missing");
      continue;
    }
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
    if (!entry->is_regular_file(ignored)) continue;
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

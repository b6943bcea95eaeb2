#include "experiments/runner/evidence.h"

#include <sys/stat.h>

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "experiments/process/tree.h"
#include "experiments/record/checksum.h"
#include "experiments/runner/disk.h"
#include "experiments/runner/program_files.h"

namespace runner {

namespace fs = std::filesystem;

double sampling_number(const std::string& experiment_hash, const record::GameKey& key) {
  const std::string digits = hash_of(experiment_hash + " " + record::game_id(key)).substr(0, 13);
  return static_cast<double>(std::stoull(digits, nullptr, 16)) / 4503599627370496.0;  // 16^13
}

Evidence::Evidence(const ResultFolder& folder, std::int64_t limit, std::span<const record::Attempt> attempts)
    : folder_(folder), limit_(limit) {
  std::map<std::pair<std::string, int>, bool> faulty;
  for (const record::Attempt& attempt : attempts) {
    faulty[{record::game_id(attempt.key), attempt.attempt}] =
        attempt.record.at_fault != record::Party::Nobody;
  }
  std::vector<std::pair<fs::file_time_type, Kept>> found;
  for (const auto& [key, is_faulty] : faulty) {
    const fs::path path = folder_.game(key.first, key.second);
    std::error_code error;
    const fs::file_time_type time = fs::last_write_time(path, error);
    if (!error) found.push_back({time, {key.first, key.second, size_of(path), is_faulty}});
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& one, const auto& other) { return one.first < other.first; });
  for (auto& [time, kept] : found) {
    size_ += kept.size;
    kept_.push_back(std::move(kept));
  }
}

namespace {

struct Found {
  fs::path path;
  std::int64_t size = 0;  ///< [bytes] by length
  bool ours = false;      ///< beside the folders in which teams write
};

/// The regular files below a folder, links not followed; nothing when it has more than `most` entries.
std::optional<std::vector<Found>> found_in(const fs::path& folder, std::size_t most) {
  std::vector<Found> files;
  std::size_t entries = 0;
  std::error_code error;
  for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    if (++entries > most) return std::nullopt;
    struct stat status {};
    if (::lstat(entry->path().c_str(), &status) != 0 || !S_ISREG(status.st_mode)) continue;
    files.push_back({entry->path(), status.st_size, entry.depth() == 0});
  }
  return files;
}

}  // namespace

std::string cut_down(const fs::path& folder, const KeptLimits& limits) {
  std::optional<std::vector<Found>> found = found_in(folder, limits.files);
  if (!found) {
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
      std::error_code ignored;
      if (entry->symlink_status(ignored).type() == fs::file_type::directory)
        process::remove_tree(entry->path());
    }
    return "what the teams wrote was removed: a game keeps at most " + std::to_string(limits.files) +
           " files";
  }
  std::vector<Found>& files = *found;
  std::sort(files.begin(), files.end(), [](const Found& a, const Found& b) {
    return std::tuple(!a.ours, a.size, a.path) < std::tuple(!b.ours, b.size, b.path);
  });
  std::int64_t kept = 0;
  std::int64_t removed = 0;
  std::size_t count = 0;
  for (const Found& file : files) {
    if (file.size <= limits.bytes - kept) {
      kept += file.size;
      continue;
    }
    process::remove_tree(file.path);
    ++count;
    removed += std::min(file.size, std::numeric_limits<std::int64_t>::max() - removed);
  }
  if (count == 0) return {};
  return std::to_string(count) + (count == 1 ? " file" : " files") + " of " + std::to_string(removed >> 20) +
         " MiB in its folder " + (count == 1 ? "was" : "were") + " removed: a game keeps at most " +
         std::to_string(limits.bytes >> 20) + " MiB";
}

void remove_odd(const fs::path& folder) {
  std::vector<fs::path> odd;
  std::error_code error;
  for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    std::error_code ignored;
    const fs::file_type kind = entry->symlink_status(ignored).type();
    if (kind != fs::file_type::regular && kind != fs::file_type::directory) odd.push_back(entry->path());
  }
  for (const fs::path& path : odd) fs::remove(path, error);
}

std::vector<record::KeptFile> files_in(const fs::path& root, const fs::path& folder) {
  std::vector<record::KeptFile> files;
  std::error_code error;
  for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    struct stat status {};
    if (::lstat(entry->path().c_str(), &status) != 0 || !S_ISREG(status.st_mode)) continue;
    try {
      files.push_back({entry->path().lexically_relative(root).generic_string(), status.st_size,
                       record::checksum_of_file(entry->path(), status.st_size)});
    } catch (const std::runtime_error&) {
      // A file that cannot be read is no reason to end a night; it has no row, and is told by `verify`.
    }
  }
  std::sort(files.begin(), files.end(), [](const auto& a, const auto& b) { return a.path < b.path; });
  return files;
}

std::vector<Evidence::Place> Evidence::add(const record::Attempt& attempt) {
  const std::string game = record::game_id(attempt.key);
  kept_.push_back({game, attempt.attempt, size_of(folder_.game(game, attempt.attempt)),
                   attempt.record.at_fault != record::Party::Nobody});
  size_ += kept_.back().size;
  return make_room();
}

std::vector<Evidence::Place> Evidence::make_room() {
  std::vector<Place> gone;
  while (size_ > limit_ && !kept_.empty()) {
    auto oldest = std::find_if(kept_.begin(), kept_.end(), [](const Kept& one) { return !one.faulty; });
    if (oldest == kept_.end()) oldest = kept_.begin();
    gone.push_back({oldest->game, oldest->attempt});
    size_ -= oldest->size;
    kept_.erase(oldest);
  }
  return gone;
}

}  // namespace runner

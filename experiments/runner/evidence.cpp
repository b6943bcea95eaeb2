#include "experiments/runner/evidence.h"

#include <algorithm>
#include <map>
#include <utility>

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

std::size_t Evidence::ended(const record::Attempt& attempt, bool sampled) {
  const bool faulty = attempt.record.at_fault != record::Party::Nobody;
  const std::string game = record::game_id(attempt.key);
  if (!faulty && !sampled) {
    folder_.forget_game(game, attempt.attempt);
    return 0;
  }
  kept_.push_back({game, attempt.attempt, size_of(folder_.game(game, attempt.attempt)), faulty});
  size_ += kept_.back().size;
  return make_room();
}

std::size_t Evidence::make_room() {
  std::size_t gone = 0;
  while (size_ > limit_ && !kept_.empty()) {
    auto oldest = std::find_if(kept_.begin(), kept_.end(), [](const Kept& one) { return !one.faulty; });
    if (oldest == kept_.end()) oldest = kept_.begin();
    folder_.forget_game(oldest->game, oldest->attempt);
    size_ -= oldest->size;
    kept_.erase(oldest);
    ++gone;
  }
  return gone;
}

}  // namespace runner

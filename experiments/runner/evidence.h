#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "experiments/record/attempt.h"
#include "experiments/runner/result_folder.h"

namespace runner {

/// A number in [0, 1) for each game of an experiment, the same in every run: who is below a share is sampled.
double sampling_number(const std::string& experiment_hash, const record::GameKey& key);

/// The files of games that are kept: of faulty ones, and of a sample of the others, within a limit of size.
///
/// Above the limit the oldest sampled ones go first, then the oldest faulty ones.
class Evidence {
 public:
  /// Takes in what earlier runs have kept.
  ///
  /// @param attempts  what the ledger holds, to tell faulty games from others
  Evidence(const ResultFolder& folder, std::int64_t limit, std::span<const record::Attempt> attempts);

  /// Keeps or throws away the files of an attempt that has just ended.
  ///
  /// @return  how many attempts' files had to go for it
  std::size_t ended(const record::Attempt& attempt, bool sampled);

  std::int64_t size() const { return size_; }  ///< [bytes] kept

 private:
  struct Kept {
    std::string game;
    int attempt = 1;
    std::int64_t size = 0;
    bool faulty = false;
  };

  std::size_t make_room();

  const ResultFolder& folder_;
  std::int64_t limit_;  ///< [bytes]
  std::int64_t size_ = 0;
  std::vector<Kept> kept_;  ///< oldest first
};

}  // namespace runner

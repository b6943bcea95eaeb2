#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "experiments/record/attempt.h"
#include "experiments/record/kept_file.h"
#include "experiments/runner/result_folder.h"

namespace runner {

/// A number in [0, 1) for each game of an experiment, the same in every run: who is below a share is sampled.
double sampling_number(const std::string& experiment_hash, const record::GameKey& key);

/// Removes what a team left in an attempt's folder that is neither a file nor a folder: links, pipes, sockets.
void remove_odd(const std::filesystem::path& folder);

/// The most that is kept of one attempt: by length, since a file with holes has one that costs its maker nothing
/// and takes whoever reads it hours. Ours: what two teams may write; 2 GiB are read in a second.
struct KeptLimits {
  std::int64_t bytes = std::int64_t{2} << 30;  ///< of all files together
  std::size_t files = 50'000;                  ///< twice what two teams may make, with ours
};

/// Removes what is too much in an attempt's folder: teams' files before ours, the longest first; of too many
/// files all that teams have made.
///
/// @return  what was removed, for the game's note, as "1 file of 1048576 MiB in its folder was removed: ...";
///          empty: nothing
std::string cut_down(const std::filesystem::path& folder, const KeptLimits& limits = {});

/// The files in an attempt's folder as they are now, for the ledger; none is read further than its length was
/// before.
///
/// @param root  the result folder, from which their names are seen
std::vector<record::KeptFile> files_in(const std::filesystem::path& root,
                                       const std::filesystem::path& folder);

/// The files of games that are kept: of faulty ones, and of a sample of the others, within a limit of size.
///
/// Above the limit the oldest sampled ones go first, then the oldest faulty ones.
class Evidence {
 public:
  /// Takes in what earlier runs have kept.
  ///
  /// @param attempts  what the ledger holds, to tell faulty games from others
  Evidence(const ResultFolder& folder, std::int64_t limit, std::span<const record::Attempt> attempts);

  /// Whether the files of an attempt are kept.
  static bool keeps(const record::Attempt& attempt, bool sampled) {
    return sampled || attempt.record.at_fault != record::Party::Nobody;
  }

  /// One attempt whose files are kept.
  struct Place {
    std::string game;
    int attempt = 1;
  };
  /// Takes in an attempt whose files are kept.
  ///
  /// @return  the attempts whose files have to go for it
  std::vector<Place> add(const record::Attempt& attempt);

  std::int64_t size() const { return size_; }  ///< [bytes] kept

 private:
  struct Kept {
    std::string game;
    int attempt = 1;
    std::int64_t size = 0;
    bool faulty = false;
  };

  std::vector<Place> make_room();

  const ResultFolder& folder_;
  std::int64_t limit_;  ///< [bytes]
  std::int64_t size_ = 0;
  std::vector<Kept> kept_;  ///< oldest first
};

}  // namespace runner

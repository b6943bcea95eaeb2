#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "experiments/record/attempt.h"
#include "experiments/record/kept_file.h"

namespace runner {

/// The files of a result folder compared with what the ledger knows of them.
struct FileCheck {
  std::size_t whole = 0;
  std::size_t unknown = 0;            ///< of games written before schema 3, or left by a killed run
  std::vector<std::string> problems;  ///< missing, changed or added ones, a sentence each
};

/// @param known     files in the ledger
/// @param attempts  in the ledger: files of others are of games that a killed run did not finish
/// @param all_rows  false: the ledger has damaged rows, so that a file without one need not have been added
FileCheck check_files(const std::filesystem::path& root, std::span<const record::KeptFile> known,
                      std::span<const record::Attempt> attempts, bool all_rows = true);

}  // namespace runner

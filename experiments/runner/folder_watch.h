#pragma once

#include <sys/stat.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "experiments/runner/result_folder.h"

namespace runner {

/// Notices that somebody removes, renames or exchanges a run's folder or ledger, which stay open and would be
/// written into to the end, where nobody finds it.
class FolderWatch {
 public:
  /// @pre the ledger is open for writing
  explicit FolderWatch(const ResultFolder& folder);

  /// What happened, where the games are as far as it is known, and how to go on; nothing while all is well. A
  /// look costs some microseconds.
  std::optional<std::string> trouble() const;

  /// The folder that was opened, under a name that goes with it wherever it is moved.
  std::filesystem::path opened() const;

 private:
  struct File {
    std::filesystem::path path;
    struct stat seen {};
  };
  std::string folder_trouble() const;

  const ResultFolder& folder_;
  std::vector<File> files_;  ///< the ledger and what SQLite has beside it
};

}  // namespace runner

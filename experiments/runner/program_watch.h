#pragma once

#include <sys/stat.h>

#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "experiments/runner/program_files.h"

namespace runner {

/// Notices that a program of the experiment was changed while the experiment runs.
///
/// Looks at size, inode and times, and reads the file again only when one of them is new.
class ProgramWatch {
 public:
  explicit ProgramWatch(std::span<const ProgramFile> files);

  /// The first file whose content is not what it was, or that is gone; nothing while all is well.
  std::optional<std::filesystem::path> changed();

 private:
  struct Entry {
    ProgramFile file;
    struct stat seen {};
  };
  std::vector<Entry> entries_;
};

}  // namespace runner

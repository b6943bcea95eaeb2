#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/runner/program_files.h"
#include "experiments/schedule/design.h"

namespace runner {

/// What is needed to make a result folder again, beside what the ledger holds.
struct Manifest {
  std::string experiment_hash;
  schedule::Design design;
  std::vector<ProgramFile> files;
  std::string version;                    ///< of matchday
  std::string protocol;                   ///< of the channel between host and team
  std::vector<std::string> command_line;  ///< that made the folder
  /// of the teams, in words: its level, and why it is not more. Every run in the folder has that level
  std::string isolation;
};

/// Writes the manifest with compiler, processor, date and, inside a git checkout, the commit.
///
/// Written when the folder is made and left alone afterwards: it says how the experiment began.
///
/// @throws record::StorageError when it cannot be written
void write_manifest(const std::filesystem::path& file, const Manifest& manifest);

/// What a manifest says of those who made the folder.
struct Origin {
  std::string experiment_hash;
  std::string identity;  ///< the hash made again from its design, protocol and files
  std::string design;    ///< as it was hashed: schedule::canonical
  std::string protocol;
  int ledger_schema = 0;  ///< that the ledger began with
  std::vector<ProgramFile> files;
  std::string matchday;
  std::string commit;
  std::string isolation;  ///< of the teams, in words; empty in very old ones
};

/// The level in a sentence about isolation: "network" of "isolation network, as asked for".
std::string level_of(const std::string& isolation);

/// Gives the teams of `design` that come from git the commits of the manifest's, so that the two can be
/// compared; where there are none the design stays as it is.
void take_commits(const Origin& origin, schedule::Design& design);

/// @throws record::StorageError when it cannot be read or is none
Origin read_manifest(const std::filesystem::path& file);

}  // namespace runner

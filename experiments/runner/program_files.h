#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/schedule/design.h"

namespace runner {

/// A file that a game depends on, and what is in it.
struct ProgramFile {
  std::filesystem::path path;
  std::string hash;                            ///< XXH3-128 of its bytes, 32 hexadecimal digits
  std::vector<std::filesystem::path> names{};  ///< absolute, as the commands have it, perhaps through links
};

/// The files in one team's command: its program and the arguments that name existing files.
///
/// @param who  how the message calls the team
/// @throws std::invalid_argument when the program cannot be found
std::vector<std::filesystem::path> team_files(const record::TeamConfig& team, const std::string& who);

/// Every file in the commands of the design's teams, each once, sorted by path.
///
/// @throws std::invalid_argument naming condition, team and program when a program cannot be found
std::vector<ProgramFile> program_files(const schedule::Design& design);

/// Those, and the program that plays the games, at the end.
///
/// @throws std::invalid_argument as above, also for that program
std::vector<ProgramFile> program_files(const schedule::Design& design, const std::string& worker);

/// One file by name.
/// @throws std::invalid_argument when it cannot be read
ProgramFile program_file(const std::filesystem::path& path);

/// XXH3-128 of a text, 32 hexadecimal digits.
std::string hash_of(const std::string& text);

/// The identity of an experiment: equal for two runs whose games must be the same.
///
/// Over the canonical design (which has rule set and realism), the contents of the teams' files and
/// of the program that plays the games, and `protocol`, the version of the channel between host and
/// team. Paths do not count.
std::string experiment_hash(const schedule::Design& design, const std::vector<ProgramFile>& files,
                            const std::string& protocol);
/// The same of a design that is canonical already.
std::string experiment_hash(const std::string& design, const std::vector<ProgramFile>& files,
                            const std::string& protocol);

}  // namespace runner

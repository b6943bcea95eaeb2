#pragma once

#include <filesystem>
#include <optional>
#include <string>

// What a game that is played by hand writes, checked before it is played.
namespace commands {

/// A file that will be written, and written over when it is there.
///
/// @param flag    that named it, for the message
/// @param ending  it must have, also with .gz behind it
/// @throws std::invalid_argument when it is a folder, has another ending (also behind a link), has no folder to
///         be in, or lies in a result folder, where only the run itself writes
void check_output(const std::string& flag, const std::optional<std::filesystem::path>& file,
                  const std::string& ending);

/// Makes the folder for what the teams print.
///
/// @param folder  empty: none
/// @throws std::invalid_argument when it cannot be made or lies in a result folder
void make_team_logs(const std::filesystem::path& folder);

}  // namespace commands

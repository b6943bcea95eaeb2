#pragma once

#include <cstddef>
#include <string>

#include "experiments/schedule/toml_reader.h"

// What names of a design may be.
namespace schedule {

/// Characters of a name. Ours: it is to stand in a table, and in the names of files, which have at most 255
/// bytes (NAME_MAX).
inline constexpr std::size_t longest_name = 100;

/// Whether files can have this name in any folder: letters, digits, '-', '_' and '.', not '.' at its begin.
bool names_files(const std::string& name);

/// @throws std::invalid_argument about the key when its value cannot name files
void check_file_name(const TomlTable& table, const std::string& key, const std::string& name);

/// @throws std::invalid_argument when the name of a team is empty, too long or no line of text that can
///         be printed as it is
void check_team_name(const TomlTable& table, const std::string& key, const std::string& name);

}  // namespace schedule

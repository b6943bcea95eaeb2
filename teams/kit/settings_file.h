#pragma once

#include <string>
#include <vector>

namespace kit {

/// One `key = value` of a settings file.
struct Setting {
  std::string key;
  std::string value;  ///< as text: 0.5, 3, true, zones
  int line = 0;
};

/// Reads a TOML file of plain keys: numbers, true or false, and strings; in the order of their lines.
///
/// @throws std::invalid_argument  with the file and line for what cannot be read, is no TOML, or is a table
///                                or list
std::vector<Setting> read_settings(const std::string& path);

}  // namespace kit

#include "experiments/schedule/names.h"

#include <algorithm>

#include "sim/console/printable.h"

namespace schedule {
namespace {

void check_length(const TomlTable& table, const std::string& key, const std::string& name) {
  const std::size_t length = console::length(name);
  if (length <= longest_name) return;
  table.reject(key, "has " + std::to_string(length) + " characters; names have at most " +
                        std::to_string(longest_name));
}

}  // namespace

bool names_files(const std::string& name) {
  const auto usual = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '_' || c == '.';
  };
  return !name.empty() && name.front() != '.' && std::all_of(name.begin(), name.end(), usual);
}

void check_file_name(const TomlTable& table, const std::string& key, const std::string& name) {
  if (!names_files(name))
    table.reject(key, "use letters, digits, '-', '_' and '.' only, since it names files");
  check_length(table, key, name);
}

void check_team_name(const TomlTable& table, const std::string& key, const std::string& name) {
  if (name.empty() || console::printable(name) != name) {
    table.reject(key, "must be one line of text, without control characters");
  }
  check_length(table, key, name);
}

}  // namespace schedule

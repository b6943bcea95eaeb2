#include "experiments/schedule/command_line.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <utility>

namespace schedule {

std::vector<std::string> split_command(std::string_view line) {
  std::vector<std::string> words;
  std::optional<std::string> word;  // nothing between words; may be empty: ''
  char quote = '\0';
  const auto add = [&word](char letter) {
    if (!word) word.emplace();
    *word += letter;
  };

  for (std::size_t i = 0; i < line.size(); ++i) {
    const char letter = line[i];
    const bool escapes = letter == '\\' && quote != '\'' && i + 1 < line.size();
    if (escapes) {
      add(line[++i]);
    } else if (quote != '\0') {
      if (letter == quote) {
        quote = '\0';
      } else {
        add(letter);
      }
    } else if (letter == '\'' || letter == '"') {
      quote = letter;
      if (!word) word.emplace();
    } else if (letter == ' ' || letter == '\t' || letter == '\n') {
      if (word) words.push_back(*std::exchange(word, std::nullopt));
    } else {
      add(letter);
    }
  }
  if (quote != '\0') {
    throw std::invalid_argument("command '" + std::string(line) + "': a " + quote + " is not closed");
  }
  if (word) words.push_back(*word);
  if (words.empty()) throw std::invalid_argument("the command is empty; give a program and its arguments");
  return words;
}

std::string usual_name(const std::vector<std::string>& command) {
  constexpr std::array interpreters{"python", "pypy", "sh", "bash", "dash", "perl", "ruby", "node", "lua"};
  const std::string name = std::filesystem::path(command.front()).filename().string();
  const std::string kind = name.substr(0, name.find_first_of("0123456789."));  // python3.11
  if (std::find(interpreters.begin(), interpreters.end(), kind) == interpreters.end()) return name;
  for (std::size_t i = 1; i < command.size() && command[i] != "-c"; ++i) {
    const std::string script = std::filesystem::path(command[i]).filename().string();
    if (!command[i].starts_with('-') && !script.empty()) return script;
  }
  return name;
}

std::string shell_line(const std::vector<std::string>& words) {
  constexpr const char* plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_./=,:+@%";
  std::string line;
  for (const std::string& word : words) {
    if (!line.empty()) line += ' ';
    if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) {
      line += word;
      continue;
    }
    line += '\'';
    for (const char letter : word) line += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
    line += '\'';
  }
  return line;
}

}  // namespace schedule

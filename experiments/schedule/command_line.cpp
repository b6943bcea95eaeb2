#include "experiments/schedule/command_line.h"

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

}  // namespace schedule

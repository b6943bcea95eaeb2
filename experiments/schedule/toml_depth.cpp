#include "experiments/schedule/toml_depth.h"

#include <algorithm>

namespace schedule {
namespace {

/// Where a string that begins at `at` ends: behind its closing quote, or at the end of a text in which it has
/// none (or, of a string of one line, of the line): that the parser refuses.
std::size_t end_of_string(std::string_view toml, std::size_t at) {
  const char quote = toml[at];
  const bool many_lines = toml.substr(at, 3) == std::string_view(quote == '"' ? "\"\"\"" : "'''");
  const std::string_view closing = toml.substr(at, many_lines ? 3 : 1);
  for (std::size_t i = at + closing.size(); i < toml.size(); ++i) {
    if (toml[i] == '\\' && quote == '"') {
      ++i;
    } else if (toml[i] == '\n' && !many_lines) {
      return i;
    } else if (toml.substr(i).starts_with(closing)) {
      i += closing.size();
      // Up to two quotes of its own may stand before the closing three.
      for (int own = 0; many_lines && own < 2 && i < toml.size() && toml[i] == quote; ++own) ++i;
      return i;
    }
  }
  return toml.size();
}

}  // namespace

std::optional<std::size_t> too_deep(std::string_view toml) {
  std::size_t line = 1;
  std::size_t brackets = 0;
  std::size_t dots = 0;
  for (std::size_t i = 0; i < toml.size(); ++i) {
    switch (toml[i]) {
      case '"':
      case '\'': {
        const std::size_t end = end_of_string(toml, i);
        const std::string_view inside = toml.substr(i, end - i);
        line += static_cast<std::size_t>(std::count(inside.begin(), inside.end(), '\n'));
        i = end - 1;
        break;
      }
      case '#':
        i = std::min(toml.find('\n', i), toml.size()) - 1;
        break;
      case '.':
        ++dots;
        break;
      case '[':
      case '{':
        ++brackets;
        dots = 0;
        break;
      case ']':
      case '}':
        brackets -= brackets > 0 ? 1 : 0;
        dots = 0;
        break;
      case '\n':
        ++line;
        dots = 0;
        break;
      case '=':
      case ',':
        dots = 0;
        break;
      default:
        break;
    }
    if (brackets > deepest || dots > deepest) return line;
  }
  return std::nullopt;
}

}  // namespace schedule

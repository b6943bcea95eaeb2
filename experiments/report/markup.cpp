#include "experiments/report/markup.h"

#include "sim/console/printable.h"

namespace report {
namespace {

std::string without_markup(const std::string& text) {
  std::string result;
  for (const char letter : text) {
    switch (letter) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\'':
        result += "&#39;";
        break;
      default:
        result += letter;
    }
  }
  return result;
}

}  // namespace

std::string escaped(const std::string& text) { return without_markup(console::printable(text)); }
std::string escaped_lines(const std::string& text) { return without_markup(console::printable_lines(text)); }

}  // namespace report

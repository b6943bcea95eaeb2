#include "autoref/referee/setup.h"

#include <charconv>
#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace referee {
namespace {

[[noreturn]] void refuse(std::string_view word, const std::string& hint) {
  throw std::invalid_argument("match set-up: cannot read '" + std::string(word) + "'; " + hint);
}

double number(std::string_view word, std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) {
    refuse(word, "expected a number");
  }
  return value;
}

void read_word(std::string_view word, Setup& setup) {
  const std::size_t equals = word.find('=');
  if (equals == std::string_view::npos) refuse(word, "expected key=value");
  const std::string_view key = word.substr(0, equals);
  const std::string_view value = word.substr(equals + 1);
  if (key == "half_length") {
    const double half_length = number(word, value);
    if (half_length <= 0 || half_length > 1e6) refuse(word, "expected seconds between 0 and 1000000");
    setup.rules.half_length = world::from_seconds(half_length);
  } else if (key == "first_kickoff") {
    if (value != "yellow" && value != "blue") refuse(word, "expected yellow or blue");
    setup.first_kickoff = value == "blue" ? world::Team::Blue : world::Team::Yellow;
  } else if (key == "robots") {
    const std::size_t comma = value.find(',');
    if (comma == std::string_view::npos) refuse(word, "expected robots=YELLOW,BLUE");
    const double yellow = number(word, value.substr(0, comma));
    const double blue = number(word, value.substr(comma + 1));
    for (const double robots : {yellow, blue}) {
      if (robots < 0 || robots > world::max_robot_number + 1) refuse(word, "expected 0 to 16 robots");
    }
    setup.robots = {static_cast<int>(yellow), static_cast<int>(blue)};
  } else if (key != "rules") {
    refuse(word, "known are rules, half_length, first_kickoff, robots");
  }
}

std::string_view next_word(std::string_view& text) {
  const std::size_t begin = std::min(text.find_first_not_of(' '), text.size());
  text.remove_prefix(begin);
  const std::string_view word = text.substr(0, text.find(' '));
  text.remove_prefix(word.size());
  return word;
}

}  // namespace

std::string setup_text(const Setup& setup) {
  char half_length[32];
  std::snprintf(half_length, sizeof half_length, "%.9g", world::seconds(setup.rules.half_length));
  return "rules=" + setup.rules.name + " half_length=" + half_length +
         " first_kickoff=" + world::name(setup.first_kickoff) +
         " robots=" + std::to_string(setup.robots.yellow) + "," + std::to_string(setup.robots.blue);
}

Setup parse_setup(std::string_view text) {
  Setup setup;
  // The rule set first: the other words change it.
  for (std::string_view rest = text, word = next_word(rest); !word.empty(); word = next_word(rest)) {
    if (word.starts_with("rules=")) setup.rules = world::rule_set(word.substr(6));
  }
  for (std::string_view rest = text, word = next_word(rest); !word.empty(); word = next_word(rest)) {
    read_word(word, setup);
  }
  return setup;
}

}  // namespace referee

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

world::Duration length(std::string_view word, std::string_view text) {
  const double seconds = number(word, text);
  if (seconds <= 0 || seconds > 1e6) refuse(word, "expected seconds between 0 and 1000000");
  return world::from_seconds(seconds);
}

void read_word(std::string_view word, Setup& setup) {
  const std::size_t equals = word.find('=');
  if (equals == std::string_view::npos) refuse(word, "expected key=value");
  const std::string_view key = word.substr(0, equals);
  const std::string_view value = word.substr(equals + 1);
  if (key == "half_length") {
    setup.rules.half_length = length(word, value);
  } else if (key == "extra_half_length") {
    setup.rules.extra_half_length = length(word, value);
  } else if (key == "winner") {
    if (value != "yes" && value != "no") refuse(word, "expected yes or no");
    setup.rules.winner = value == "yes";
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
    refuse(word, "known are rules, half_length, first_kickoff, robots, winner, extra_half_length");
  }
}

std::string_view next_word(std::string_view& text) {
  const std::size_t begin = std::min(text.find_first_not_of(' '), text.size());
  text.remove_prefix(begin);
  const std::string_view word = text.substr(0, text.find(' '));
  text.remove_prefix(word.size());
  return word;
}

std::string in_seconds(world::Duration duration) {
  char text[32];
  std::snprintf(text, sizeof text, "%.9g", world::seconds(duration));
  return text;
}

}  // namespace

std::string setup_text(const Setup& setup) {
  std::string text = "rules=" + setup.rules.name + " half_length=" + in_seconds(setup.rules.half_length) +
                     " first_kickoff=" + world::name(setup.first_kickoff) +
                     " robots=" + std::to_string(setup.robots.yellow) + "," +
                     std::to_string(setup.robots.blue);
  if (setup.rules.winner) {
    text += " winner=yes extra_half_length=" + in_seconds(setup.rules.extra_half_length);
  }
  return text;
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

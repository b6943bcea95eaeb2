#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "experiments/host/match.h"
#include "experiments/judge/game.h"

namespace judge {
namespace {

[[noreturn]] void reject(const std::string& text, const std::string& problem) {
  throw std::invalid_argument("--shadow " + text + ": " + problem);
}

double number_in(const std::string& text, const std::string& word) {
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc{} || end != word.data() + word.size() || !std::isfinite(value)) {
    reject(text, "'" + word + "' is no number");
  }
  return value;
}

world::TouchAlgorithms algorithms_in(const std::string& text, const std::string& words) {
  world::TouchAlgorithms algorithms;
  std::istringstream stream(words);
  for (std::string word; std::getline(stream, word, '+');) {
    if (word == "accel") {
      algorithms.accel = true;
    } else if (word == "line") {
      algorithms.line = true;
    } else if (word == "backtrack") {
      algorithms.backtrack = true;
    } else if (word == "reach") {
      algorithms.reach = true;
    } else if (word == "likelihood") {
      algorithms.likelihood = true;
    } else {
      reject(text,
             "'" + word + "' is no touch algorithm; known are accel, line, backtrack, reach, likelihood");
    }
  }
  return algorithms;
}

}  // namespace

ShadowConfig parse_shadow(const std::string& text) {
  ShadowConfig shadow;
  shadow.name = text;
  if (text.empty() || text == acting_name) reject(text, "is the acting referee, which is always there");
  if (text.starts_with("net:") || text.starts_with("net@")) {
    const auto colon = text.find(':');
    if (colon == std::string::npos || text.find_first_not_of(' ', colon + 1) == std::string::npos) {
      reject(text, "give the outside autoref's command line, as net:COMMAND or net@4:COMMAND");
    }
    shadow.command = text.substr(colon + 1);
    if (text[3] == '@') shadow.net_speed = number_in(text, text.substr(4, colon - 4));
    if (shadow.net_speed < 0.1 || shadow.net_speed > 100) reject(text, "the pace is 0.1 to 100 real times");
    return shadow;
  }
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, ',');) {
    const auto equals = part.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == part.size()) {
      reject(text, "'" + part +
                       "' is not KEY=VALUE, as rules=paper, touch=accel+line, exit_frames=5 or "
                       "vision.ball_sigma=0.002, nor net:COMMAND");
    }
    const std::string key = part.substr(0, equals);
    const std::string value = part.substr(equals + 1);
    if (key == "rules") {
      world::rule_set(value);  // says which there are
      shadow.rules = value;
    } else if (key == "touch") {
      shadow.touch = algorithms_in(text, value);
    } else if (key == "exit_frames") {
      const double frames = number_in(text, value);
      if (frames < 1 || frames > 60 || frames != std::floor(frames)) reject(text, "exit_frames is 1 to 60");
      shadow.exit_frames = static_cast<int>(frames);
    } else if (key.starts_with("vision.")) {
      if (key == "vision.cameras" || key == "vision.camera_height") {
        reject(text, "all referees share the game's cameras; change what they see");
      }
      shadow.realism[key] = number_in(text, value);
      record::RealismConfig check;
      check.changes = shadow.realism;
      host::realism_of(check);
    } else {
      reject(text, "unknown key '" + key +
                       "'; known are rules, touch, exit_frames and the keys vision.* of "
                       "matchday realism");
    }
  }
  return shadow;
}

std::vector<ShadowConfig> sweeps() {
  std::vector<ShadowConfig> all;
  for (const char* text :
       {"vision.ball_sigma=0", "vision.ball_sigma=0.001", "vision.ball_sigma=0.002",
        "vision.ball_sigma=0.003", "vision.ball_sigma=0.005", "vision.ball_missing=0.02",
        "vision.ball_missing=0.05", "vision.ball_missing=0.1", "vision.delay=0", "vision.delay=3",
        "vision.delay=6", "vision.bias_sigma=0", "vision.bias_sigma=0.02", "vision.bias_sigma=0.03"}) {
    all.push_back(parse_shadow(text));
  }
  return all;
}

}  // namespace judge

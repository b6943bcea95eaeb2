#include "autoref/automaton/pictures.h"

#include <cmath>
#include <cstdio>

#include "autoref/automaton/positions.h"
#include "autoref/automaton/transitions.h"

namespace automaton {
namespace {

constexpr double grid = 0.25;    // [m]
constexpr double beyond = 0.25;  // [m] outside the lines, where a ball that left may lie

std::string number(double metres) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3f", std::abs(metres) < 5e-4 ? 0.0 : metres);
  return text;
}

std::string pair(const world::Vector2d& place) {
  return "[" + number(place.x()) + ", " + number(place.y()) + "]";
}

}  // namespace

std::string table_json() {
  std::string text = "{\n  \"locations\": [";
  for (int i = 0; i <= static_cast<int>(world::Location::Break); ++i) {
    text += std::string(i > 0 ? ", " : "") + "\"" + world::name(static_cast<world::Location>(i)) + "\"";
  }
  text += "],\n  \"rows\": [";
  bool first = true;
  for (const Row& row : transitions()) {
    text += std::string(first ? "" : ",") + "\n    {\"name\": \"" + std::string(row.name) +
            "\", \"from\": \"" + world::name(row.from) + "\", \"to\": \"" + world::name(row.to) +
            "\", \"condition\": \"" + std::string(row.condition) +
            "\", \"sends\": " + (row.command ? "true" : "false") + "}";
    first = false;
  }
  return text + "\n  ]\n}\n";
}

std::string positions_json(const world::RuleSet& rules) {
  const world::Field& field = rules.field;
  const world::GameState state;
  std::string text = "{\n  \"length\": " + number(field.length) + ", \"width\": " + number(field.width) +
                     ", \"goal_width\": " + number(field.goal_width) +
                     ", \"area_radius\": " + number(field.defense_area.radius) +
                     ", \"area_stretch\": " + number(field.defense_area.stretch) +
                     ", \"free_kick_area_distance\": " + number(rules.free_kick_area_distance) +
                     ",\n  \"points\": [";
  const int columns = static_cast<int>(std::lround((field.half_length() + beyond) / grid));
  const int rows = static_cast<int>(std::lround((field.half_width() + beyond) / grid));
  bool first = true;
  for (int i = -columns; i <= columns; ++i) {
    for (int j = -rows; j <= rows; ++j) {
      const world::Vector2d place(i * grid, j * grid);
      text += std::string(first ? "" : ",") + "\n    {\"place\": " + pair(place) +
              ", \"yellow\": " + pair(free_kick_position(rules, state, world::Team::Yellow, place)) +
              ", \"blue\": " + pair(free_kick_position(rules, state, world::Team::Blue, place)) +
              ", \"neutral\": " + pair(neutral_position(rules, place)) + "}";
      first = false;
    }
  }
  return text + "\n  ]\n}\n";
}

}  // namespace automaton

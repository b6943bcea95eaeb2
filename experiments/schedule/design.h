#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "experiments/record/match_config.h"
#include "experiments/schedule/limits.h"

namespace schedule {

/// What is varied: team A and team B as they play under this condition.
struct Condition {
  std::string name;
  record::TeamConfig a;
  record::TeamConfig b;
  record::RealismConfig realism{};
  bool operator==(const Condition&) const = default;
};

/// An experiment: which teams meet under which conditions, how often, under which rules.
struct Design {
  std::string name;
  std::string description;
  std::uint64_t seed = 1;
  int pairs = 1;  ///< per condition; a pair is two games with the colours exchanged
  std::string rules = "ssl-2015";
  std::optional<double> half_length;  ///< [s] instead of the rule set's
  bool winner = false;                ///< a draw is followed by extra time and a shoot-out
  record::RealismConfig realism;      ///< where a condition has no other
  int forfeit_goals = 3;              ///< a game lost at the table counts 0 to this
  Limits limits;
  std::vector<Condition> conditions;
  std::string text;  ///< the file as it was read
};

/// Says what is wrong with a realism by throwing std::invalid_argument; this folder does not know the engine.
using CheckRealism = std::function<void(const record::RealismConfig&)>;

/// The design in a TOML file; the format is in experiments/designs/README.md.
///
/// @throws std::invalid_argument "file:line: key = value: what is wrong; what would be right"
Design read_design(const std::filesystem::path& file, const CheckRealism& check = {});

/// The design in a text; `file` is what messages call it.
Design parse_design(const std::string& text, const std::string& file, const CheckRealism& check = {});

/// The [realism] of a TOML file that may hold other things too, as `ssl-autoref calibrate` writes it.
/// @throws std::invalid_argument as read_design, and when there is none
record::RealismConfig read_realism(const std::filesystem::path& file, const CheckRealism& check = {});

/// Everything in the design that decides games or tables, as one line of JSON with its keys in a fixed order.
///
/// Comments, order of keys, the description and other ways to write the same do not matter.
std::string canonical(const Design& design);

}  // namespace schedule

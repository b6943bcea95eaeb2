#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "experiments/process/isolation.h"
#include "experiments/record/match_config.h"
#include "experiments/schedule/limits.h"
#include "experiments/schedule/stopping.h"

namespace schedule {

/// [s] Two halves, each with the longest overrun, must stay below the host's 40 minutes (DESIGN, "Clock").
inline constexpr double longest_half = 1'100;

/// Where a team that is built from git comes from; its command is seen from the top of the checkout.
struct Source {
  std::string repository;  ///< path or address, as git takes it
  std::string revision;    ///< branch, tag or commit, as the design says it
  std::string build;       ///< for the shell, in the checkout; empty: nothing is to be built
  std::string commit{};    ///< 40 hexadecimal digits once `builds` has looked it up
  bool operator==(const Source&) const = default;
};

/// A game of a panel: A or B against one of several opponents, which stands where B stands otherwise.
struct PanelPlace {
  std::string base;      ///< the condition that is played against the panel
  std::string opponent;  ///< its name
  char arm = 'a';        ///< who meets it: 'a' or 'b'
  bool operator==(const PanelPlace&) const = default;
};

/// What is varied: team A and team B as they play under this condition.
struct Condition {
  std::string name;
  record::TeamConfig a;
  record::TeamConfig b;
  record::RealismConfig realism{};
  std::optional<Source> a_source{};
  std::optional<Source> b_source{};
  std::string sweep{};                     ///< the sweep it is a point of; empty: none
  std::map<std::string, double> values{};  ///< of a sweep: what is varied, by its key ("b.speed_factor")
  std::optional<PanelPlace> panel{};
  bool operator==(const Condition&) const = default;
};

/// An experiment: which teams meet under which conditions, how often, under which rules.
struct Design {
  std::string name;
  std::string description;
  std::uint64_t seed = 1;
  int pairs = 1;  ///< per condition, the most if `stopping` says so; a pair is two games, colours exchanged
  std::string rules = "ssl-2015";
  std::optional<double> half_length;  ///< [s] instead of the rule set's
  bool winner = false;                ///< a draw is followed by extra time and a shoot-out
  record::RealismConfig realism;      ///< where a condition has no other
  int forfeit_goals = 3;              ///< a game lost at the table counts 0 to this
  Stopping stopping;
  Limits limits;
  // What teams see of the machine; no part of a game's result, nor of the experiment's hash.
  std::optional<process::Isolation> isolation{};  ///< nothing: the strongest the machine allows
  std::vector<std::filesystem::path> visible{};   ///< what isolated teams see nevertheless
  std::vector<Condition> conditions;              ///< sweeps and panel written out
  std::string text;                               ///< the file as it was read
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

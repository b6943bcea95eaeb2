#pragma once

#include <span>
#include <string>
#include <vector>

#include "experiments/judge/game.h"

namespace judge {

/// One table of the study, as text.
struct Table {
  std::string name;  ///< of its file: "a_exits"
  std::string title;
  std::string note;  ///< what the columns mean
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
  std::string command{};  ///< that made it
};

/// Fewer than this are too few to say anything, and what is to be reached: what the study asks for.
struct Wanted {
  int exits = 3000;
  int goals = 300;
  int events = 200;  ///< of every other row
  int near_misses = 200;
  double last_team = 0.99;  ///< right, of clear exits
  bool all_goals = true;    ///< else only that one is asked for
  double extra_exits = 1;   ///< at most, in 1000
  double event = 0.95;      ///< precision and recall of every other event
  double p = 0.01;          ///< the likelihood against all three
};
Wanted wanted_of(std::string_view preset);

/// The summary and tables a to h. All games are of one realism.
/// @param command  that made them, to be written with each
std::vector<Table> tables(std::span<const GameResult> games, const std::string& command = {});

std::string as_markdown(std::span<const Table> tables);
std::string as_csv(const Table& table);
std::string as_json(std::span<const Table> tables);

}  // namespace judge

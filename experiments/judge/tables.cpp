#include "experiments/judge/tables.h"

#include "experiments/judge/tables/parts.h"

namespace judge {

Wanted wanted_of(std::string_view preset) {
  if (preset == "harsh") return {.exits = 1000, .last_team = 0.97, .all_goals = false};
  return {};
}

std::vector<Table> tables(std::span<const GameResult> games, const std::string& command) {
  const Wanted wanted = wanted_of(games.empty() ? "" : games.front().preset);
  std::vector<Table> all = {summary_table(games, wanted),
                            exits_table(games, wanted),
                            situations_table(games),
                            failing_exits_table(games),
                            touch_teams_table(games, wanted),
                            goals_table(games, wanted),
                            events_table(games, wanted, true),
                            events_table(games, wanted, false),
                            calibration_table(games),
                            strata_table(games),
                            sweep_table(games),
                            touches_table(games)};
  for (Table& table : all) table.command = command;
  return all;
}

}  // namespace judge

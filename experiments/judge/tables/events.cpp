#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiments/judge/tables/counting.h"
#include "experiments/judge/tables/parts.h"
#include "sim/world/rules/rule_set.h"

namespace judge {
namespace {

std::vector<std::string> event_row(std::span<const GameResult> games, const std::string& shadow, Event event,
                                   const Wanted& wanted) {
  const Cases cases = cases_of(games, shadow, [&](const Case& one) { return one.event == event; });
  int found = 0, missed = 0, extra = 0, close_called = 0, close = 0, right = 0, named = 0, ambiguous = 0,
      tenth = 0;
  for (const Case* one : cases) {
    if (one->result == Result::Extra) {
      ++extra;
    } else if (one->ambiguous()) {
      ++ambiguous;
    } else if (one->close()) {
      ++close;
      if (one->result == Result::Found) ++close_called;
    } else if (one->result == Result::Missed) {
      ++missed;
    } else {
      ++found;
      if (std::abs(world::seconds(one->call->time - one->truth->time)) <= 0.1) ++tenth;
      if (one->truth->by && one->call->by) {
        ++named;
        const bool team_only = event == Event::TooManyRobots;
        right += team_only ? one->truth->by->team == one->call->by->team : *one->truth->by == *one->call->by;
      }
    }
  }
  int near_misses = 0;
  for (const GameResult& game : games) near_misses += game.near_misses[static_cast<std::size_t>(event)];
  const char* few = found + missed < wanted.events     ? "too few"
                    : near_misses < wanted.near_misses ? "too few near misses"
                                                       : "";
  return {std::string(name(event)),
          whole(found + missed),
          whole(near_misses),
          share(found, found + extra),
          share(found, found + missed),
          whole(tenth),
          named > 0 ? fmt::format("{}/{}", right, named) : "",
          delays(cases),
          fmt::format("{}/{}", close_called, close),
          whole(ambiguous),
          few};
}

const std::vector<std::string> event_columns = {
    "event",       "true",  "near misses",      "precision", "recall", "within 0.1 s",
    "right robot", "delay", "close: called of", "ambiguous", ""};
constexpr const char* event_note =
    "True: beyond the limit by at least a band. Near misses: lawful, within two bands of the limit. Close: "
    "within one "
    "band on either side, outside precision and recall. Delay: median and 95 % in ms.";

}  // namespace

Table events_table(std::span<const GameResult> games, const Wanted& wanted, bool speed) {
  Table table{speed ? "d_ball_speed" : "e_events",
              speed ? "d) Ball speed" : "e) Every other event of the catalogue",
              event_note,
              event_columns,
              {}};
  for (const std::string& shadow : shadows_of(games)) {
    if (shadow != acting_name && shadow != "rules=paper") continue;
    for (const Event event : all_events()) {
      if (event == Event::Exit || event == Event::Goal) continue;
      if ((event == Event::BallTooFast) != speed) continue;
      if (shadow != acting_name) {
        const world::RuleSet& paper = world::rule_set("paper");
        if (!world::runs(paper, detector_of(event))) continue;
      }
      std::vector<std::string> row = event_row(games, shadow, event, wanted);
      if (shadow != acting_name) row.front() += " (" + shadow + ")";
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

}  // namespace judge

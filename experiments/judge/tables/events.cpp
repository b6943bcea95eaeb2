#include <fmt/format.h>

#include "experiments/judge/tables/counting.h"
#include "experiments/judge/tables/parts.h"

namespace judge {
namespace {

std::string remark(const EventClasses& all, const Wanted& wanted) {
  const std::string events = too_few(all.happened(), wanted.events, "events");
  const std::string near = too_few(all.near_misses, wanted.near_misses, "near misses");
  return events + (events.empty() || near.empty() ? "" : ", ") + near;
}

std::vector<std::string> event_row(std::span<const GameResult> games, const std::string& shadow, Event event,
                                   const Wanted& wanted) {
  const EventClasses all(games, shadow, event);
  const Cases cases = cases_of(games, shadow, [&](const Case& one) { return one.event == event; });
  return {shadow,
          std::string(name(event)),
          whole(all.happened()),
          whole(all.near_misses),
          all.called() > 0 ? share(all.found, all.called()) : "never called",
          all.happened() > 0 ? share(all.found, all.happened()) : "never happened",
          whole(all.late),
          whole(all.within_tenth),
          all.named > 0 ? fmt::format("{}/{}", all.right_robot, all.named) : "",
          delays(cases),
          fmt::format("{}/{}", all.close_called, all.close),
          whole(all.ambiguous),
          remark(all, wanted)};
}

const std::vector<std::string> event_columns = {
    "referee",      "event",       "true",  "near misses",      "precision", "recall", "late",
    "within 0.1 s", "right robot", "delay", "close: called of", "ambiguous", "remark"};
constexpr const char* event_note =
    "True: beyond the limit by at least a band. Near misses: lawful, within two bands of the limit. Close: "
    "within one band on either side, outside precision and recall. Late: called more than 0.3 s after it was "
    "clear: true, not found, and no extra call. Delay: median and 95 % in ms.";

}  // namespace

Table events_table(std::span<const GameResult> games, const Wanted& wanted, bool speed) {
  Table table{speed ? "d_ball_speed" : "e_events",
              speed ? "d) Ball speed" : "e) Every other event of the catalogue",
              event_note,
              event_columns,
              {}};
  for (const std::string& shadow : shadows_of(games)) {
    if (!is_other_referee(shadow)) continue;
    for (const Event event : all_events()) {
      if (event == Event::Exit || event == Event::Goal) continue;
      if ((event == Event::BallTooFast) != speed || !may_call(shadow, event)) continue;
      table.rows.push_back(event_row(games, shadow, event, wanted));
    }
  }
  return table;
}

}  // namespace judge

#include <fmt/format.h>

#include <algorithm>

#include "experiments/judge/tables/counting.h"
#include "experiments/judge/tables/parts.h"
#include "experiments/stats/sign_test.h"

namespace judge {

Table sweep_table(std::span<const GameResult> games) {
  Table table{"g_sweeps",
              "g2) Other eyes, other parameters",
              "Each referee sees the same games; with other cameras through its own, with the same random "
              "numbers. p: "
              "McNemar's exact test of correct calls of clear exits (right here alone : right with ours "
              "alone). Brier: "
              "as in f, of the probabilities with which it called clear exits.",
              {"referee", "last team right", "missed exits", "extra", "chip extra", "p against ours", "Brier",
               "delay"},
              {}};
  for (const std::string& shadow : shadows_of(games)) {
    const Cases cases = cases_of(games, shadow, is_exit);
    const ExitClasses all(cases);
    std::vector<std::pair<double, bool>> said;
    for (const Case* one : cases) {
      if (!clear_exit(*one) || one->result != Result::Found || !one->call->last) continue;
      said.emplace_back(one->call->last->probability, one->team_is_right());
    }
    int only_it = 0;
    int only_ours = 0;
    for (const GameResult& game : games) {
      std::vector<std::pair<world::Time, bool>> ours;
      for (const Case& one : game.cases) {
        if (one.shadow == acting_name && clear_exit(one))
          ours.emplace_back(one.truth->time, one.team_is_right());
      }
      for (const Case& one : game.cases) {
        if (one.shadow != shadow || !clear_exit(one)) continue;
        const auto same = std::ranges::find(ours, one.truth->time, &std::pair<world::Time, bool>::first);
        if (same == ours.end()) continue;
        only_it += one.team_is_right() && !same->second;
        only_ours += same->second && !one.team_is_right();
      }
    }
    table.rows.push_back(
        {shadow, share(all.correct, all.correct + all.wrong), share(all.all_missed(), all.all()),
         whole(all.extra), whole(all.chip),
         shadow == acting_name
             ? ""
             : fmt::format("{:.2g} ({}:{})", stats::sign_test(only_it, only_ours), only_it, only_ours),
         brier(said), delays(cases)});
  }
  return table;
}

}  // namespace judge

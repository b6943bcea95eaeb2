#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiments/judge/tables/counting.h"
#include "experiments/judge/tables/parts.h"

namespace judge {

Table touches_table(std::span<const GameResult> games) {
  Table table{"h_touches",
              "h) Touches in play",
              "Impulse of a substep above 1 mN s, 50 ms apart. Recall by kind; precision over all; again: "
              "named once more "
              "within a touch that was found. A named touch stands for every true one of that robot that it "
              "overlaps; one to one: when it may stand for one only.",
              {"touches by", "window"},
              {}};
  for (std::size_t k = 0; k < kinds; ++k) table.columns.emplace_back(name(static_cast<Kind>(k)));
  for (const char* column : {"all", "one to one", "precision", "extra", "again"})
    table.columns.emplace_back(column);
  std::vector<TouchCount> sums;
  for (const GameResult& game : games) {
    for (const TouchCount& count : game.touches) {
      auto sum = std::ranges::find_if(sums, [&](const TouchCount& one) {
        return one.witness == count.witness && one.window == count.window;
      });
      if (sum == sums.end()) {
        sums.push_back(count);
        continue;
      }
      for (std::size_t k = 0; k < kinds; ++k) {
        sum->found[k] += count.found[k];
        sum->missed[k] += count.missed[k];
      }
      sum->own += count.own;
      sum->extra += count.extra;
      sum->again += count.again;
    }
  }
  for (const TouchCount& sum : sums) {
    std::vector<std::string> row = {sum.witness, fmt::format("{:.1f} s", sum.window)};
    int found = 0;
    int all = 0;
    for (std::size_t k = 0; k < kinds; ++k) {
      row.push_back(share(sum.found[k], sum.found[k] + sum.missed[k]));
      found += sum.found[k];
      all += sum.found[k] + sum.missed[k];
    }
    row.push_back(share(found, all));
    row.push_back(share(sum.own, all));
    row.push_back(share(found, found + sum.extra));
    row.push_back(whole(sum.extra));
    row.push_back(whole(sum.again));
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace judge

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "experiments/judge/tables/counting.h"
#include "experiments/judge/tables/parts.h"
#include "experiments/stats/sign_test.h"

namespace judge {

Table touch_teams_table(std::span<const GameResult> games, const Wanted& wanted) {
  const Sayings sayings = sayings_of(games);
  const auto rows = sayings.witnesses.size();
  const auto three = sayings.witness("all three");
  Table table{"b_last_touch",
              "b) Last touching team (the paper's Table 8)",
              "At the same clear exits, as called by the acting referee's detectors. p: McNemar's exact "
              "two-sided test "
              "(exits that only this row, and only the other, had right).",
              {"touches by", "last team right", "last robot right", "p against all three",
               "p against the row above", "remark"},
              {}};
  const auto mcnemar = [&](std::size_t a, std::size_t b) {
    const auto [only_a, only_b] = sayings.against(a, b);
    return fmt::format("{:.2g} ({}:{})", stats::sign_test(only_a, only_b), only_a, only_b);
  };
  for (std::size_t w = 0; w < rows; ++w) {
    int good = 0;
    int robot = 0;
    for (const Case* exit : sayings.exits) {
      good += sayings.right(w, *exit);
      robot += sayings.right(w, *exit) && exit->call->witnesses[w]->robot == exit->truth->last->robot;
    }
    const auto n = static_cast<std::int64_t>(sayings.exits.size());
    table.rows.push_back({sayings.witnesses[w], share(good, n), share(robot, n),
                          !three || w == *three ? "" : mcnemar(w, *three), w == 0 ? "" : mcnemar(w, w - 1),
                          too_few(n, wanted.exits, "clear exits")});
  }
  return table;
}

Table strata_table(std::span<const GameResult> games) {
  const Sayings sayings = sayings_of(games);
  Table table{
      "g_strata",
      "g1) Last touching team by what happened",
      "Clear exits that were called, as in b. Lost: the longest stretch of ticks in which no camera saw "
      "the ball from its last touch to the exit. Crowded: robots of both teams within 150 mm of the ball "
      "at the touch. Brier: as in f, of the likelihood's probability.",
      {"exits", "count"},
      {}};
  const auto likelihood = sayings.witness("likelihood");
  for (const std::string& witness : sayings.witnesses) table.columns.push_back(witness);
  table.columns.emplace_back("Brier");
  const auto row = [&](const std::string& what, const std::function<bool(const Case&)>& wanted) {
    Cases exits;
    for (const Case* exit : sayings.exits) {
      if (wanted(*exit)) exits.push_back(exit);
    }
    std::vector<std::string> fields = {what, whole(static_cast<std::int64_t>(exits.size()))};
    for (std::size_t w = 0; w < sayings.witnesses.size(); ++w) {
      const auto good =
          std::ranges::count_if(exits, [&](const Case* exit) { return sayings.right(w, *exit); });
      fields.push_back(share(good, static_cast<std::int64_t>(exits.size())));
    }
    std::vector<std::pair<double, bool>> said;
    for (const Case* exit : exits) {
      if (!likelihood || !exit->call->witnesses.at(*likelihood)) continue;
      said.emplace_back(exit->call->witnesses[*likelihood]->probability, sayings.right(*likelihood, *exit));
    }
    fields.push_back(brier(said));
    table.rows.push_back(std::move(fields));
  };
  row("all", [](const Case&) { return true; });
  for (std::size_t k = 0; k < kinds; ++k) {
    const Kind kind = static_cast<Kind>(k);
    row(std::string(name(kind)), [=](const Case& one) { return one.truth->last->kind == kind; });
  }
  row("at the line", [](const Case& one) { return one.truth->last->at_line; });
  row("chip", [](const Case& one) { return one.truth->last->chip; });
  row("crowded", [](const Case& one) { return one.truth->last->crowded; });
  row("never lost", [](const Case& one) { return one.truth->last->lost == 0; });
  row("lost 1 to 3 ticks",
      [](const Case& one) { return one.truth->last->lost >= 1 && one.truth->last->lost <= 3; });
  row("lost 4 to 10 ticks",
      [](const Case& one) { return one.truth->last->lost >= 4 && one.truth->last->lost <= 10; });
  row("lost longer", [](const Case& one) { return one.truth->last->lost > 10; });
  return table;
}

Table calibration_table(std::span<const GameResult> games) {
  Table table{
      "f_calibration",
      "f) The last touch's probability",
      "Of the likelihood, at clear exits that were called. Calibrated: the right team's interval holds "
      "the mean said. Brier: mean square of the difference between what was said and what was (0: "
      "perfect; 0.25: a coin).",
      {"probability said", "exits", "mean said", "right team"},
      {}};
  const Sayings sayings = sayings_of(games);
  const auto likelihood = sayings.witness("likelihood");
  if (!likelihood) return table;
  const std::size_t w = *likelihood;
  constexpr std::array bounds = {0.0, 0.5, 0.6, 0.7, 0.8, 0.9, 0.97, 0.99, 1.0001};
  std::vector<std::pair<double, bool>> all;
  for (std::size_t b = 0; b + 1 < bounds.size(); ++b) {
    int n = 0;
    int good = 0;
    double sum = 0;
    for (const Case* exit : sayings.exits) {
      const auto& said = exit->call->witnesses.at(w);
      if (!said || said->probability < bounds[b] || said->probability >= bounds[b + 1]) continue;
      const bool right = sayings.right(w, *exit);
      ++n;
      good += right;
      sum += said->probability;
      all.emplace_back(said->probability, right);
    }
    table.rows.push_back({fmt::format("{:.2f} to {:.2f}", bounds[b], std::min(bounds[b + 1], 1.0)), whole(n),
                          n > 0 ? fmt::format("{:.3f}", sum / n) : "", share(good, n)});
  }
  table.rows.push_back({"Brier score", whole(std::ssize(all)), "", all.empty() ? "none" : brier(all)});
  return table;
}

}  // namespace judge

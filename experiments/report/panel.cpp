#include "experiments/report/panel.h"

#include <fmt/format.h>

#include "experiments/report/wording.h"

namespace report {
namespace {

double share(std::int64_t wins, std::int64_t games) {
  return games > 0 ? static_cast<double>(wins) / static_cast<double>(games) : 0;
}

/// A's and B's goal differences in the pairs both have.
struct Matched {
  std::vector<double> a;
  std::vector<double> b;
  std::vector<double> differences;
  void add(double of_a, double of_b) {
    a.push_back(of_a);
    b.push_back(of_b);
    differences.push_back(of_a - of_b);
  }
};

PanelComparison::Line line_of(const std::string& opponent, const Matched& matched,
                              const std::array<PanelGames, 2>& games) {
  PanelComparison::Line line;
  line.opponent = opponent;
  line.pairs = static_cast<std::int64_t>(matched.differences.size());
  line.a = stats::mean_of(matched.a);
  line.b = stats::mean_of(matched.b);
  line.test = stats::t_test(stats::mean_of(matched.differences));
  line.win_share = share(games[0].wins, games[0].games) - share(games[1].wins, games[1].games);
  line.win_share_interval = stats::newcombe(games[0].wins, games[0].games, games[1].wins, games[1].games);
  return line;
}

}  // namespace

std::string PanelComparison::title() const {
  return fmt::format("{}: A ({}) compared with B ({}) against the same opponents", base, a, b);
}

std::string PanelComparison::sentence() const {
  if (lines.empty() || lines.back().pairs < 2) return title() + ": too few pairs to say anything";
  const Line& last = lines.back();
  return fmt::format("{}: A's goal difference minus B's is {} {} a game (p {}; {} pairs{})", title(),
                     signed_number(last.test.difference, 2), bracketed(last.test.interval),
                     !last.test.known || last.test.p < 0.001 ? p_value(last.test) : "= " + p_value(last.test),
                     last.pairs, lines.size() > 1 ? ", all opponents" : "");
}

PanelComparison compare_panel(const std::string& base,
                              const std::map<std::string, std::array<PanelGames, 2>>& opponents) {
  PanelComparison panel;
  panel.base = base;
  std::map<int, std::array<double, 2>> sums;
  std::map<int, std::size_t> times;
  std::array<PanelGames, 2> all;
  for (const auto& [opponent, games] : opponents) {
    panel.a = games[0].team;
    panel.b = games[1].team;
    Matched matched;
    for (const auto& [number, of_a] : games[0].differences) {
      const auto found = games[1].differences.find(number);
      if (found == games[1].differences.end()) continue;
      matched.add(of_a, found->second);
      sums[number][0] += of_a;
      sums[number][1] += found->second;
      ++times[number];
    }
    panel.lines.push_back(line_of(opponent, matched, games));
    for (std::size_t arm = 0; arm < 2; ++arm) {
      all.at(arm).wins += games.at(arm).wins;
      all.at(arm).games += games.at(arm).games;
    }
  }
  if (opponents.size() < 2) return panel;
  Matched matched;
  const double count = static_cast<double>(opponents.size());
  for (const auto& [number, sum] : sums) {
    if (times[number] == opponents.size()) matched.add(sum[0] / count, sum[1] / count);
  }
  panel.lines.push_back(line_of("all", matched, all));
  return panel;
}

}  // namespace report

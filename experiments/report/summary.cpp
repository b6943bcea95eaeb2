#include "experiments/report/summary.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <set>

#include "experiments/stats/many_tests.h"
#include "experiments/stats/resampling.h"
#include "experiments/stats/sign_test.h"

namespace report {
namespace {

using record::Attempt;
using record::Outcome;
using record::Party;

constexpr double usual_level = 0.05;  // of the sign test in a verdict

bool is_forfeit(const Attempt& game) { return game.record.at_fault != Party::Nobody; }

/// "0.031", "< 0.001"
std::string p_text(double p) {
  if (p < 0.001) return "< 0.001";
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3f", p);
  return text.data();
}

/// Counts of one condition while they are collected.
class Counter {
 public:
  Counter(const Header::Condition& condition, int forfeit_goals) : forfeit_goals_(forfeit_goals) {
    row_.condition = condition.name;
    row_.a.name = condition.a.name;
    row_.b.name = condition.b.name;
  }

  void add(const Pair& pair) {
    std::array<double, 2> legs{};
    for (std::size_t leg = 0; leg < legs.size(); ++leg) legs.at(leg) = add(*pair.at(leg));
    legs_.push_back(legs);
    row_.pair_numbers.push_back(pair[0]->key.pair);
    row_.pair_differences.push_back((legs[0] + legs[1]) / 2);
    pairs_.push_back(pair);
  }

  Row row(int void_attempts, int given_up_pairs) {
    row_.difference = stats::mean_of(row_.pair_differences);
    row_.t_test = stats::t_test(row_.difference);
    row_.bootstrap = stats::bootstrap(row_.pair_differences);
    row_.permutation_p = stats::sign_flip(row_.pair_differences);
    row_.correlation = stats::pair_correlation(legs_);
    row_.comparisons = compare(pairs_);
    row_.game_numbers = game_numbers(pairs_);
    row_.a.goals = stats::mean_of(goals_a_);
    row_.b.goals = stats::mean_of(goals_b_);
    row_.a.win_share = stats::wilson(row_.a.wins, row_.games);
    row_.b.win_share = stats::wilson(row_.b.wins, row_.games);
    row_.p = stats::sign_test(row_.a.wins, row_.b.wins);
    const double played = played_ > 0 ? played_ : 1;
    row_.a.fouls /= played;
    row_.b.fouls /= played;
    row_.stoppages /= played;
    row_.void_attempts = void_attempts;
    row_.given_up_pairs = given_up_pairs;
    return row_;
  }

 private:
  /// @return goal difference from A's view
  double add(const Attempt& game) {
    const world::Team a = game.a_colour;
    const world::Team b = world::opponent(a);
    const world::PerTeam<int> goals = record::counted_goals(game.record, forfeit_goals_);
    ++row_.games;
    goals_a_.push_back(goals[a]);
    goals_b_.push_back(goals[b]);
    const Outcome outcome = record::outcome(game.record);
    if (outcome == Outcome::Draw) {
      ++row_.draws;
    } else {
      const world::Team winner = outcome == Outcome::BlueWins ? world::Team::Blue : world::Team::Yellow;
      ++(winner == a ? row_.a : row_.b).wins;
    }
    if (is_forfeit(game)) {
      ++(game.record.at_fault == record::party(a) ? row_.a : row_.b).forfeits;
    } else {
      played_ += 1;
      row_.a.fouls += game.record.fouls[a];
      row_.b.fouls += game.record.fouls[b];
      row_.stoppages += game.record.stoppages;
    }
    return goals[a] - goals[b];
  }

  int forfeit_goals_;
  Row row_;
  double played_ = 0;
  std::vector<double> goals_a_;
  std::vector<double> goals_b_;
  std::vector<std::array<double, 2>> legs_;  ///< goal differences of the two games
  std::vector<Pair> pairs_;
};

/// Holm's adjustment over the conditions that are questions of their own.
void adjust(std::vector<Row>& rows, const std::vector<Header::Condition>& conditions) {
  std::vector<Row*> asked;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (conditions[i].sweep.empty() && !conditions[i].panel && rows[i].games > 0) asked.push_back(&rows[i]);
  }
  if (asked.size() < 2) return;
  std::vector<double> p;
  std::vector<double> permutation;
  for (const Row* row : asked) {
    p.push_back(row->p);
    permutation.push_back(row->permutation_p);
  }
  p = stats::holm(p);
  permutation = stats::holm(permutation);
  for (std::size_t i = 0; i < asked.size(); ++i) {
    asked[i]->p_holm = p[i];
    asked[i]->permutation_p_holm = permutation[i];
  }
}

std::vector<PanelComparison> panels_of(const std::vector<Row>& rows,
                                       const std::vector<Header::Condition>& conditions) {
  std::map<std::string, std::map<std::string, std::array<PanelGames, 2>>> found;  // base, opponent, arm
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!conditions[i].panel) continue;
    const Header::Condition::Panel& place = *conditions[i].panel;
    PanelGames& games = found[place.base][place.opponent].at(place.arm == 'a' ? 0 : 1);
    games.team = rows[i].a.name;
    games.wins = rows[i].a.wins;
    games.games = rows[i].games;
    for (std::size_t k = 0; k < rows[i].pair_numbers.size(); ++k)
      games.differences[rows[i].pair_numbers[k]] = rows[i].pair_differences[k];
  }
  std::vector<PanelComparison> panels;
  for (const auto& [base, opponents] : found) panels.push_back(compare_panel(base, opponents));
  return panels;
}

std::vector<Sweep> sweeps_of(const std::vector<Row>& rows, const std::vector<Header::Condition>& conditions) {
  std::map<std::pair<std::string, std::string>, std::vector<std::pair<double, std::size_t>>> places;
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    if (conditions[i].sweep.empty()) continue;
    for (const auto& [key, value] : conditions[i].values)
      places[{conditions[i].sweep, key}].emplace_back(value, i);
  }
  std::vector<Sweep> found;
  for (auto& [name, points] : places) {
    std::sort(points.begin(), points.end());
    if (points.front().first == points.back().first) continue;
    Sweep sweep;
    sweep.name = name.first;
    sweep.key = name.second;
    std::vector<stats::SweepPoint> values;
    for (const auto& [x, row] : points) {
      sweep.x.push_back(x);
      sweep.rows.push_back(row);
      values.push_back({x, rows[row].pair_differences});
    }
    sweep.trend = stats::trend(values);
    found.push_back(std::move(sweep));
  }
  return found;
}

}  // namespace

bool Row::shows_difference() const {
  return games > 0 && answer.empty() && p_holm.value_or(p) < usual_level &&
         permutation_p_holm.value_or(permutation_p) < usual_level;
}

std::string Row::verdict() const {
  if (games == 0) return "no game counts yet";
  const std::string how_sure = std::string("(p ") + (p < 0.001 ? "" : "= ") + p_text(p) +
                               (p_holm ? "; Holm " + p_text(*p_holm) : "") + ")";
  if (!answer.empty()) return answer;
  if (p_holm.value_or(p) >= usual_level) return "no difference shown " + how_sure;
  const std::string verdict =
      (a.wins > b.wins ? "A wins more games than it loses " : "A loses more games than it wins ") + how_sure;
  if (shows_difference()) return verdict;
  return verdict + " if the games of a pair are independent; over pairs not shown (sign flips p " +
         p_text(permutation_p_holm.value_or(permutation_p)) + ")";
}

Summary summarise(Header header, std::span<const Attempt> attempts) {
  std::map<std::string, std::map<int, std::vector<const Attempt*>>> by_condition;
  for (const Attempt& attempt : attempts)
    by_condition[attempt.key.condition][attempt.key.pair].push_back(&attempt);

  Summary summary;
  summary.header = std::move(header);
  bool any_forfeit = false;
  for (const Header::Condition& condition : summary.header.conditions) {
    Counter all(condition, summary.header.forfeit_goals);
    Counter clean(condition, summary.header.forfeit_goals);
    int voids = 0;
    int given_up = 0;
    std::set<std::string> hashes;
    for (const auto& [number, pair_attempts] : by_condition[condition.name]) {
      const record::PairState state = record::pair_state(pair_attempts);
      voids += state.voids;
      given_up += state.given_up ? 1 : 0;
      if (!state.complete()) continue;
      all.add(state.legs);
      const bool forfeit = is_forfeit(*state.legs[0]) || is_forfeit(*state.legs[1]);
      any_forfeit = any_forfeit || forfeit;
      if (!forfeit) clean.add(state.legs);
      for (const Attempt* leg : state.legs) {
        if (!is_forfeit(*leg) && !hashes.insert(leg->record.hash).second) ++summary.repeated_games;
      }
    }
    summary.rows.push_back(all.row(voids, given_up));
    summary.without_forfeits.push_back(clean.row(voids, given_up));
    if (!condition.answer.empty()) {
      summary.rows.back().answer = condition.answer;
      summary.without_forfeits.back().answer = "not tested alone: the sequential test counts forfeits";
    }
    summary.games += summary.rows.back().games;
    summary.planned += 2 * summary.header.pairs;
  }
  if (!any_forfeit) summary.without_forfeits.clear();
  adjust(summary.rows, summary.header.conditions);
  adjust(summary.without_forfeits, summary.header.conditions);
  summary.panels = panels_of(summary.rows, summary.header.conditions);
  summary.sweeps = sweeps_of(summary.rows, summary.header.conditions);
  return summary;
}

}  // namespace report

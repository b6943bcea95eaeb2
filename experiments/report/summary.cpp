#include "experiments/report/summary.h"

#include <cstdio>
#include <map>
#include <set>

#include "experiments/stats/sign_test.h"

namespace report {
namespace {

using record::Attempt;
using record::Outcome;
using record::Party;

constexpr double usual_level = 0.05;  // of the sign test in a verdict

using Pair = std::array<const Attempt*, 2>;

bool is_forfeit(const Attempt& game) { return game.record.at_fault != Party::Nobody; }

/// Counts of one condition while they are collected.
class Counter {
 public:
  Counter(const Header::Condition& condition, int forfeit_goals) : forfeit_goals_(forfeit_goals) {
    row_.condition = condition.name;
    row_.a.name = condition.a.name;
    row_.b.name = condition.b.name;
  }

  void add(const Pair& pair) {
    double difference = 0;
    for (const Attempt* game : pair) difference += add(*game) / 2;
    differences_.push_back(difference);
  }

  Row row(int void_attempts, int given_up_pairs) {
    row_.difference = stats::mean_of(differences_);
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
  std::vector<double> differences_;
};

}  // namespace

std::string Row::verdict() const {
  if (games == 0) return "no game counts yet";
  std::array<char, 64> p_text{};
  if (p < 0.001) {
    std::snprintf(p_text.data(), p_text.size(), "(p < 0.001)");
  } else {
    std::snprintf(p_text.data(), p_text.size(), "(p = %.3f)", p);
  }
  if (p >= usual_level) return std::string("no difference shown ") + p_text.data();
  return std::string(a.wins > b.wins ? "A wins more games than it loses "
                                     : "A loses more games than it wins ") +
         p_text.data();
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
    summary.games += summary.rows.back().games;
    summary.planned += 2 * summary.header.pairs;
  }
  if (!any_forfeit) summary.without_forfeits.clear();
  return summary;
}

}  // namespace report

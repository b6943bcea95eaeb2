#include "experiments/report/comparison.h"

#include <cmath>
#include <functional>
#include <set>

#include "experiments/record/match_statistics.h"
#include "experiments/stats/many_tests.h"

namespace report {
namespace {

using record::MatchRecord;
using world::Team;
using Value = std::function<double(const MatchRecord&, Team)>;

bool played_to_its_end(const Pair& pair) {
  return pair[0]->record.at_fault == record::Party::Nobody &&
         pair[1]->record.at_fault == record::Party::Nobody;
}

bool has_statistics(const Pair& pair) {
  return pair[0]->record.statistics.has_value() && pair[1]->record.statistics.has_value();
}

/// Collects one statistic over the pairs; nothing when no pair has it.
void add(std::vector<Comparison>& found, Comparison comparison, std::span<const Pair> pairs,
         const Value& value) {
  std::vector<double> a;
  std::vector<double> b;
  std::vector<double> differences;
  for (const Pair& pair : pairs) {
    std::array<double, 2> of_a{};
    std::array<double, 2> of_b{};
    double difference = 0;
    for (std::size_t leg = 0; leg < 2; ++leg) {
      const record::Attempt& game = *pair.at(leg);
      of_a.at(leg) = value(game.record, game.a_colour);
      of_b.at(leg) = value(game.record, world::opponent(game.a_colour));
      difference += (of_a.at(leg) - of_b.at(leg)) / 2;
    }
    if (std::isnan(difference)) continue;
    a.insert(a.end(), of_a.begin(), of_a.end());
    b.insert(b.end(), of_b.begin(), of_b.end());
    differences.push_back(difference);
  }
  if (differences.empty()) return;
  comparison.a = stats::mean_of(a);
  comparison.b = stats::mean_of(b);
  comparison.test = stats::t_test(stats::mean_of(differences));
  found.push_back(std::move(comparison));
}

double fouls_of_kind(const MatchRecord& record, Team team, const std::string& kind) {
  const auto found = record.fouls_by_kind[team].find(kind);
  return found == record.fouls_by_kind[team].end() ? 0 : found->second;
}

}  // namespace

std::vector<Comparison> compare(std::span<const Pair> pairs) {
  std::vector<Pair> watched;
  std::set<std::string> kinds;
  for (const Pair& pair : pairs) {
    if (!played_to_its_end(pair) || !has_statistics(pair)) continue;
    watched.push_back(pair);
    for (const record::Attempt* game : pair) {
      for (const Team team : world::both_teams) {
        for (const auto& [kind, count] : game->record.fouls_by_kind[team]) kinds.insert(kind);
      }
    }
  }
  std::vector<Comparison> found;
  for (const record::Statistic& statistic : record::team_statistics()) {
    add(found, {statistic.name, statistic.label, statistic.decimals, {}, {}, {}, 1}, watched,
        [&](const MatchRecord& record, Team team) { return statistic.value(*record.statistics, team); });
  }
  add(found, {"fouls", "fouls", 2, {}, {}, {}, 1}, watched,
      [](const MatchRecord& record, Team team) { return static_cast<double>(record.fouls[team]); });
  for (const std::string& kind : kinds) {
    add(found, {"foul_" + kind, "  " + kind, 2, {}, {}, {}, 1}, watched,
        [&](const MatchRecord& record, Team team) { return fouls_of_kind(record, team, kind); });
  }
  std::vector<double> p;
  std::vector<Comparison*> tested;  // the others have no p to adjust
  for (Comparison& comparison : found) {
    if (comparison.test.known) tested.push_back(&comparison);
  }
  for (const Comparison* comparison : tested) p.push_back(comparison->test.p);
  p = stats::holm(p);
  for (std::size_t i = 0; i < tested.size(); ++i) tested[i]->p_holm = p[i];
  return found;
}

std::vector<GameNumber> game_numbers(std::span<const Pair> pairs) {
  std::vector<GameNumber> found;
  for (const record::Statistic& statistic : record::game_statistics()) {
    std::vector<double> values;
    for (const Pair& pair : pairs) {
      if (!played_to_its_end(pair) || !has_statistics(pair)) continue;
      for (const record::Attempt* game : pair) {
        const double value = statistic.value(*game->record.statistics, Team::Yellow);
        if (!std::isnan(value)) values.push_back(value);
      }
    }
    if (!values.empty())
      found.push_back({statistic.name, statistic.label, statistic.decimals, stats::mean_of(values)});
  }
  return found;
}

}  // namespace report

#include "experiments/report/health.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <set>
#include <tuple>

#include "experiments/stats/intervals.h"
#include "experiments/stats/many_tests.h"

namespace report {
namespace {

using record::Attempt;
using record::Outcome;
using record::Party;

constexpr std::size_t most_reasons = 10;

/// 0, 1, 2: A has won, drawn, lost.
std::size_t result_of_a(const Attempt& game) {
  const Outcome outcome = record::outcome(game.record);
  if (outcome == Outcome::Draw) return 1;
  const world::Team winner = outcome == Outcome::BlueWins ? world::Team::Blue : world::Team::Yellow;
  return winner == game.a_colour ? 0 : 2;
}

std::string fault_of(const Attempt& game) {
  const char* how = record::name(game.record.termination);
  switch (game.record.at_fault) {
    case Party::Both:
      return fmt::format("both teams {}", how);
    case Party::Harness:
    case Party::Nobody:
      return how;
    case Party::Yellow:
    case Party::Blue:
      break;
  }
  return fmt::format("{} {}", game.record.at_fault == record::party(game.a_colour) ? "A" : "B", how);
}

Health::Check check(const std::string& what, std::span<const Attempt* const> games,
                    const std::function<std::string(const Attempt&)>& group_of) {
  std::map<std::string, std::vector<std::int64_t>> groups;
  for (const Attempt* game : games) {
    auto& counts = groups[group_of(*game)];
    counts.resize(3);
    ++counts[result_of_a(*game)];
  }
  std::vector<stats::GroupCounts> table;
  for (auto& [name, counts] : groups) table.push_back({name, counts});
  stats::Homogeneity found = stats::homogeneity(table);
  if (found.freedom == 0) {
    // One of the three results is too rare to be expected anywhere: wins against all else.
    for (stats::GroupCounts& group : table)
      group.counts = {group.counts[0], group.counts[1] + group.counts[2]};
    found = stats::homogeneity(table);
  }
  return {what, std::move(found)};
}

/// "2026-11-21 20 h" of "2026-11-21T20:15:00Z"
std::string hour(const std::string& started) {
  return started.size() < 13 ? "unknown" : started.substr(0, 10) + " " + started.substr(11, 2) + " h";
}

/// The end A defends first.
std::string end_of_a(const Attempt& game) {
  return (game.a_colour == world::Team::Blue) == game.blue_on_positive_half ? "+x" : "-x";
}

}  // namespace

std::string Health::Check::text() const {
  if (result.freedom == 0) return "too few games to say";
  std::string text = fmt::format("chi-square {:.1f} with {} degree{} of freedom, p = {:.3f}",
                                 result.chi_square, result.freedom, result.freedom == 1 ? "" : "s", result.p);
  if (p_holm >= suspicious) return text;
  const auto worst = std::min_element(result.rows.begin(), result.rows.end(),
                                      [](const auto& a, const auto& b) { return a.p < b.p; });
  return text + fmt::format(": SUSPICIOUS, most of all {}", worst->name);
}

const char* AuditLine::meaning() const {
  switch (verdict) {
    case record::Verdict::Same:
      return "the same hash";
    case record::Verdict::TeamDiffers:
      return "another hash, the same from the recorded replies: a team is not deterministic (no fault, but "
             "its games cannot be played again from their seeds)";
    case record::Verdict::SimulatorDiffers:
      return "another hash from the same replies: A MISTAKE OF MATCHDAY, please report it";
    case record::Verdict::TeamsOrUsDiffer:
      return "another hash, and no recorded replies to tell a team from the simulator";
    case record::Verdict::Failed:
      return "could not be played again";
  }
  return "";
}

std::vector<AuditLine> audit_lines(std::span<const record::Audit> audits) {
  constexpr std::size_t most_named = 5;
  std::map<record::Verdict, AuditLine> lines;
  for (const record::Audit& audit : audits) {
    AuditLine& line = lines[audit.verdict];
    line.verdict = audit.verdict;
    ++line.count;
    if (audit.verdict == record::Verdict::Same) continue;
    if (line.count <= most_named) line.games += (line.games.empty() ? "" : ", ") + record::game_id(audit.key);
    if (line.count == most_named + 1) line.games += ", ...";
  }
  std::vector<AuditLine> result;
  for (auto& [verdict, line] : lines) result.push_back(std::move(line));
  return result;
}

Health health_of(std::span<const Attempt> attempts) {
  Health health;
  std::map<std::string, std::set<std::string>> hashes;
  std::vector<const Attempt*> games;
  std::map<std::tuple<int, std::string, int>, double> differences;  // by pair, condition, leg: the schedule
  std::vector<const Attempt*> faulty;
  for (const Attempt& attempt : attempts) {
    ++health.attempts;
    const bool is_void = record::outcome(attempt.record) == Outcome::Void;
    const bool finished = !is_void && attempt.record.at_fault == Party::Nobody;
    health.voids += is_void ? 1 : 0;
    health.finished += finished ? 1 : 0;
    health.forfeits += !is_void && !finished ? 1 : 0;
    if (!finished) {
      ++health.faults[fault_of(attempt)];
      faulty.push_back(&attempt);
      continue;
    }
    hashes[attempt.key.condition].insert(attempt.record.hash);
    games.push_back(&attempt);
    const world::PerTeam<int>& goals = attempt.record.goals;
    differences[{attempt.key.pair, attempt.key.condition, attempt.key.leg}] =
        goals[attempt.a_colour] - goals[world::opponent(attempt.a_colour)];
  }
  for (const auto& [condition, distinct] : hashes)
    health.distinct += static_cast<std::int64_t>(distinct.size());

  std::stable_sort(faulty.begin(), faulty.end(),
                   [](const Attempt* a, const Attempt* b) { return a->started < b->started; });
  const std::size_t first = faulty.size() > most_reasons ? faulty.size() - most_reasons : 0;
  for (std::size_t i = first; i < faulty.size(); ++i) {
    health.reasons.push_back(record::game_id(faulty[i]->key) + ": " + fault_of(*faulty[i]) + ", " +
                             faulty[i]->record.reason);
  }

  const auto colour = [](const Attempt& game) { return std::string(world::name(game.a_colour)); };
  const auto kickoff = [](const Attempt& game) {
    return std::string(game.first_kickoff == game.a_colour ? "A" : "B");
  };
  const auto worker = [](const Attempt& game) { return "worker " + std::to_string(game.worker); };
  const auto when = [](const Attempt& game) { return hour(game.started); };
  health.checks = {check("worker", games, worker), check("hour", games, when),
                   check("colour of A", games, colour), check("end A defends first", games, end_of_a),
                   check("first kickoff", games, kickoff)};
  std::vector<double> p;
  for (const Health::Check& one : health.checks) {
    if (one.result.freedom > 0) p.push_back(one.result.p);
  }
  p = stats::holm(p);
  std::size_t next = 0;
  for (Health::Check& one : health.checks) {
    if (one.result.freedom > 0) one.p_holm = p[next++];
  }

  // Of each condition its own mean is taken off, and each round of the schedule gives one value: neither
  // sweeps nor the order of conditions within a round must look like a pattern in time.
  std::map<std::string, std::vector<double>> by_condition;
  for (const auto& [place, difference] : differences) by_condition[std::get<1>(place)].push_back(difference);
  std::map<int, std::vector<double>> rounds;
  for (const auto& [place, difference] : differences) {
    const double usual = stats::mean_of(by_condition[std::get<1>(place)]).mean;
    rounds[std::get<0>(place)].push_back(difference - usual);
  }
  std::vector<double> sequence;
  for (const auto& [number, values] : rounds) sequence.push_back(stats::mean_of(values).mean);
  health.runs = stats::runs_test(sequence);
  return health;
}

}  // namespace report

#include "experiments/runner/preflight.h"

#include <algorithm>
#include <utility>

namespace runner {
namespace {

constexpr double half_length = 15;  // [s]: both teams take a kickoff; with its stops about 1.5 simulated
                                    // minutes, half a second of a processor

}  // namespace

std::vector<PreflightGame> preflight_games(const schedule::Design& design) {
  std::vector<PreflightGame> games;
  std::vector<std::pair<std::vector<std::string>, std::vector<std::string>>> seen;
  for (std::size_t i = 0; i < design.conditions.size(); ++i) {
    const schedule::Condition& condition = design.conditions[i];
    const std::pair pairing{condition.a.command, condition.b.command};
    if (std::find(seen.begin(), seen.end(), pairing) != seen.end()) continue;
    seen.push_back(pairing);
    Job job{schedule::game(design, 2 * i), 1};
    job.game.config.half_length = std::min(half_length, job.game.config.half_length.value_or(half_length));
    job.game.config.winner = false;
    games.push_back({std::move(job)});
  }
  return games;
}

PreflightFinding judged(const PreflightGame& game) {
  const record::GameKey& key = game.job.game.key;
  const std::string who = "condition '" + key.condition + "'";
  for (const record::MatchRecord& record : game.records) {
    if (record.at_fault == record::Party::Nobody && record.termination == record::Termination::Finished)
      continue;
    return {true, who + ": " + (record.reason.empty() ? record::name(record.termination) : record.reason)};
  }
  const bool same = std::all_of(game.records.begin(), game.records.end(),
                                [&](const auto& record) { return record.hash == game.records.front().hash; });
  if (same) return {};
  return {false, who +
                     ": the same short game went differently the second time: a team is not deterministic, "
                     "so its games cannot be played again from their seeds"};
}

}  // namespace runner

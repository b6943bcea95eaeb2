#include "experiments/runner/preflight.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "experiments/runner/pace.h"

namespace runner {
namespace {

// [s]: both teams take a kickoff; with its stops about 1.5 simulated minutes, half a second of a processor
constexpr double half_length = 15;
constexpr std::size_t times = 2;  // each, to compare the hashes

}  // namespace

std::vector<PreflightGame> preflight_games(const schedule::Design& design) {
  std::vector<PreflightGame> games;
  // What plays: the command, and the checkout of a team from git.
  using Program = std::pair<std::vector<std::string>, std::filesystem::path>;
  std::vector<std::pair<Program, Program>> seen;
  for (std::size_t i = 0; i < design.conditions.size(); ++i) {
    const schedule::Condition& condition = design.conditions[i];
    const std::pair<Program, Program> pairing{{condition.a.command, condition.a.directory},
                                              {condition.b.command, condition.b.directory}};
    const int count = 2 * design.pairs;
    if (const auto known = std::find(seen.begin(), seen.end(), pairing); known != seen.end()) {
      games[static_cast<std::size_t>(known - seen.begin())].games += count;
      continue;
    }
    seen.push_back(pairing);
    Job job{schedule::game(design, 2 * i), 1};
    job.game.config.half_length = std::min(half_length, job.game.config.half_length.value_or(half_length));
    job.game.config.winner = false;
    games.push_back({.job = std::move(job), .games = count});
  }
  return games;
}

std::optional<int> play_preflight(std::vector<PreflightGame>& games, Crew& crew, const ResultFolder& folder,
                                  const std::function<std::string()>& date,
                                  const std::function<std::optional<int>()>& look) {
  const std::size_t all = times * games.size();
  std::vector<std::size_t> playing(crew.places());
  for (std::size_t begun = 0, ended = 0; ended < all;) {
    for (; crew.has_room() && begun < all; ++begun) {
      PreflightGame& game = games[begun / times];
      const std::filesystem::path place = folder.preflight() / std::to_string(begun);
      try {
        playing[crew.start(Purpose::Preflight, game.job, place, date())] = begun / times;
      } catch (const std::runtime_error& error) {
        game.records.push_back(never_started(error));
        ++ended;
      }
    }
    if (const auto signal = look()) {
      crew.end();
      return signal;
    }
    for (Crew::Ended& one : crew.collect()) {
      games[playing[one.slot]].records.push_back(std::move(one.attempt.record));
      ++ended;
    }
  }
  return std::nullopt;
}

PreflightFinding judged(const PreflightGame& game, const schedule::Design& design) {
  const record::GameKey& key = game.job.game.key;
  const std::string who = "condition '" + key.condition + "'";
  for (const record::MatchRecord& record : game.records) {
    if (record.at_fault == record::Party::Nobody && record.termination == record::Termination::Finished)
      continue;
    return {true, who + ": " + (record.reason.empty() ? record::name(record.termination) : record.reason)};
  }
  const Pace pace = pace_of(game.job.game.config, game.records, game.games);
  if (const std::string problem = budget_problem(design, pace); !problem.empty()) {
    return {true, who + ": " + problem};
  }
  const bool same = std::all_of(game.records.begin(), game.records.end(),
                                [&](const auto& record) { return record.hash == game.records.front().hash; });
  if (same) return {};
  return {false, who +
                     ": the same short game went differently the second time: a team is not deterministic, "
                     "so its games cannot be played again from their seeds"};
}

PreflightVerdict verdict(const std::vector<PreflightGame>& games, const schedule::Design& design,
                         std::size_t places) {
  PreflightVerdict all;
  std::vector<Pace> paces;
  for (const PreflightGame& game : games) {
    paces.push_back(pace_of(game.job.game.config, game.records, game.games));
    const PreflightFinding finding = judged(game, design);
    if (finding.failed) {
      all.failure = "a short game before the first one failed: " + finding.sentence;
      return all;
    }
    if (!finding.sentence.empty()) all.remarks.push_back(finding.sentence);
  }
  if (const std::string slow = slowest_team(design, paces, places); !slow.empty())
    all.remarks.push_back(slow);
  return all;
}

}  // namespace runner

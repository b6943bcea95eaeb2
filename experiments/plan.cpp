#include <fmt/format.h>
#include <sched.h>

#include <array>
#include <chrono>
#include <cmath>
#include <iostream>
#include <map>
#include <set>
#include <utility>

#include "experiments/commands.h"
#include "experiments/exit_code.h"
#include "experiments/experiment.h"
#include "experiments/one_game.h"
#include "experiments/plan_text.h"
#include "experiments/record/json_text.h"
#include "experiments/runner/pace.h"
#include "experiments/runner/preflight.h"
#include "experiments/schedule/schedule.h"
#include "experiments/start.h"
#include "experiments/stats/correlation.h"
#include "experiments/stats/intervals.h"
#include "sim/world/rules/rule_set.h"

namespace commands {
namespace {

constexpr double calibration_half = 30;  // [s] long enough that starting the teams is a small part
// A team that takes long for every tick must not make a plan take long (ours).
constexpr std::chrono::seconds longest_short_game{20};
constexpr std::chrono::seconds longest_calibration{60};

int processors() {
  cpu_set_t set;
  CPU_ZERO(&set);
  return ::sched_getaffinity(0, sizeof set, &set) == 0 ? CPU_COUNT(&set) : 1;
}

bool counts(const record::Attempt& attempt) { return attempt.record.at_fault == record::Party::Nobody; }

double half_of(const schedule::Design& design) {
  return design.half_length.value_or(world::seconds(world::rule_set(design.rules).half_length));
}

/// From games of a ledger, scaled to the design's length of a half.
std::optional<Speed> speed_of(const Experiment& experiment, const schedule::Design& design,
                              const std::filesystem::path& folder) {
  std::vector<double> seconds;
  for (const record::Attempt& attempt : experiment.attempts) {
    if (counts(attempt)) seconds.push_back(attempt.record.wall_seconds);
  }
  if (seconds.empty()) return std::nullopt;
  const double scale = half_of(design) / half_of(experiment.design);
  return Speed{scale * stats::mean_of(seconds).mean,
               fmt::format("measured: {} games in {}", seconds.size(), folder.string())};
}

/// How games of a ledger differ, each condition around its own mean.
std::optional<Spread> spread_of(const Experiment& experiment) {
  std::map<std::pair<std::string, int>, std::map<int, double>> pairs;
  std::map<std::string, std::vector<double>> conditions;
  Spread spread;
  double draws = 0;
  for (const record::Attempt& attempt : experiment.attempts) {
    if (!counts(attempt)) continue;
    const auto& goals = attempt.record.goals;
    const double difference = goals[attempt.a_colour] - goals[world::opponent(attempt.a_colour)];
    pairs[{attempt.key.condition, attempt.key.pair}][attempt.key.leg] = difference;
    conditions[attempt.key.condition].push_back(difference);
    draws += difference == 0;
    ++spread.games;
  }
  double squares = 0;
  double freedom = 0;
  for (const auto& [name, values] : conditions) {
    const stats::Mean mean = stats::mean_of(values);
    squares += mean.deviation * mean.deviation * static_cast<double>(mean.count - 1);
    freedom += static_cast<double>(mean.count - 1);
  }
  if (freedom < 8) return std::nullopt;  // too few to say anything
  spread.goal_deviation = std::sqrt(squares / freedom);
  spread.draws = draws / static_cast<double>(spread.games);
  std::vector<std::array<double, 2>> both;
  for (const auto& [key, legs] : pairs) {
    if (legs.size() != 2) continue;
    const double mean = stats::mean_of(conditions[key.first]).mean;
    both.push_back({legs.at(0) - mean, legs.at(1) - mean});
  }
  if (both.size() >= 8) spread.correlation = stats::pair_correlation(both).value;
  return spread;
}

/// What plays: commands, commits and hindrances, whatever the names.
std::set<std::string> teams_of(const schedule::Design& design) {
  std::set<std::string> teams;
  for (const schedule::Condition& one : design.conditions) {
    for (const auto& [team, source] : {std::pair{&one.a, &one.a_source}, std::pair{&one.b, &one.b_source}}) {
      record::TeamConfig nameless = *team;
      nameless.name.clear();
      nameless.directory.clear();
      teams.insert(record::to_json(nameless) + ((*source) ? (*source)->revision : ""));
    }
  }
  return teams;
}

/// How the earlier games differ from the design's; empty when they do not.
std::string other_games(const schedule::Design& earlier, const schedule::Design& design,
                        const std::filesystem::path& folder) {
  std::string text;
  const auto note = [&](const std::string& what) {
    text += "note: the games in " + folder.string() + " " + what + "\n";
  };
  if (teams_of(earlier) != teams_of(design)) note("are of other teams; pace and spread may be others too");
  if (half_of(earlier) != half_of(design)) {
    note(fmt::format("have halves of {:g} s, the design's have {:g} s: times are scaled, goals are not",
                     half_of(earlier), half_of(design)));
  }
  return text;
}

/// A signal ended the measuring.
struct Interrupted {
  int signal = 0;
};

/// Short games of every two programs that meet in the design, here and now.
///
/// @param remark  a team that is too slow is added to it
/// @throws std::invalid_argument when a game cannot be played
/// @throws Interrupted           when a signal ended one
Speed calibrate(schedule::Design& design, const std::filesystem::path& folder, int workers,
                std::string& remark) {
  using Clock = std::chrono::steady_clock;
  build_teams(design, folder);
  const auto isolation = chosen_isolation(design.isolation, "isolation =").level;
  const auto visible = visible_paths(design.visible, "visible =");
  std::vector<runner::Pace> paces;
  const std::vector<runner::PreflightGame> games = runner::preflight_games(design);
  double all = 0;
  const Clock::time_point begin = Clock::now();
  for (const runner::PreflightGame& one : games) {
    const Clock::time_point now = Clock::now();
    if (!paces.empty() && now - begin > longest_calibration) break;
    record::MatchConfig config = one.job.game.config;
    config.half_length = std::min(calibration_half, half_of(design));
    host::Options settings;
    set_team_time(design.limits.team_time, settings);
    settings.isolation = isolation;
    settings.visible = visible;
    settings.interrupted = [&] { return Clock::now() - now > longest_short_game; };
    const OneGame game = play_one_game(config, nullptr, false, settings);
    if (game.signal) throw Interrupted{*game.signal};
    const bool long_enough = game.record.termination == record::Termination::Interrupted;
    if (game.record.at_fault != record::Party::Nobody && !long_enough) {
      throw std::invalid_argument(
          "the short game that measures the pace ended by a fault: " + game.record.reason +
          "; mend that first, since no game of the design can be played");
    }
    paces.push_back(runner::pace_of(config, {game.record}, one.games));
    all += one.games;
    if (const std::string problem = runner::budget_problem(design, paces.back()); !problem.empty()) {
      remark += "note: " + problem + "\n";
    }
  }
  if (const std::string slow = runner::slowest_team(design, paces, static_cast<std::size_t>(workers));
      !slow.empty())
    remark += "note: " + slow + "\n";
  const double tick = runner::expected_seconds(design, paces, 1) / runner::full_game_ticks(design) / all;
  const std::string which = games.size() == 1 ? "a short game"
                                              : fmt::format("short games of {} of {} pairings of programs",
                                                            paces.size(), games.size());
  return {tick * runner::full_game_ticks(design),
          fmt::format("measured: {} just now, {:.0f} times real time; a busy machine looks slower", which,
                      world::tick_length / tick)};
}

int print_plan(const PlanOptions& options) {
  check_temporary_folder(Games::Here);
  schedule::Design design = checked_design(options.design);
  std::filesystem::path folder = options.from;
  if (folder.empty() && std::filesystem::exists(usual_folder(design) / "ledger.sqlite"))
    folder = usual_folder(design);
  std::optional<Speed> speed;
  std::optional<Spread> spread;
  std::string remark;
  if (!folder.empty()) {
    const Experiment earlier = read_experiment(folder);
    speed = speed_of(earlier, design, folder);
    spread = spread_of(earlier);
    remark = other_games(earlier.design, design, folder);
  }
  const int workers = options.workers > 0 ? options.workers : processors();
  if (!speed) speed = calibrate(design, usual_folder(design), workers, remark);
  std::cout << plan_text(design, speed, spread, workers) << remark;
  return done;
}

}  // namespace

int plan(const PlanOptions& options) {
  try {
    return print_plan(options);
  } catch (const Interrupted& interrupted) {
    return signal_base + interrupted.signal;
  }
}

}  // namespace commands

#include <fmt/format.h>
#include <sched.h>

#include <array>
#include <cmath>
#include <iostream>
#include <map>
#include <set>
#include <utility>

#include "experiments/builds/builds.h"
#include "experiments/commands.h"
#include "experiments/exit_code.h"
#include "experiments/experiment.h"
#include "experiments/one_game.h"
#include "experiments/plan_text.h"
#include "experiments/record/json_text.h"
#include "experiments/schedule/schedule.h"
#include "experiments/start.h"
#include "experiments/stats/correlation.h"
#include "experiments/stats/intervals.h"
#include "sim/world/rules/rule_set.h"

namespace commands {
namespace {

constexpr double calibration_half = 30;  // [s] long enough that starting the teams is a small part
// A game goes on a little after the time of each half: 1228.7 s of 1200 in the game of the README.
constexpr double overrun = 1.024;

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

/// A short game of the first condition, here and now.
Speed calibrate(schedule::Design& design, const std::filesystem::path& folder) {
  builds::prepare(design, folder / "builds", std::cerr);
  record::MatchConfig config = schedule::game(design, 0).config;
  config.half_length = std::min(calibration_half, half_of(design));
  config.winner = false;
  host::Options settings;
  settings.isolation = chosen_isolation(design.isolation, "isolation =").level;
  settings.visible = visible_paths(design.visible, "visible =");
  const OneGame game = play_one_game(config, nullptr, false, settings);
  if (game.record.at_fault != record::Party::Nobody) {
    throw std::invalid_argument(
        "the short game that measures the pace ended by a fault: " + game.record.reason +
        "; mend that first, since no game of the design can be played");
  }
  const double simulated = static_cast<double>(game.record.ticks) * world::tick_length;
  const double pace = simulated / game.record.wall_seconds;
  return {2 * half_of(design) * overrun / pace,
          fmt::format("measured: a game of {:.0f} simulated s just now, {:.0f} times real time; a busy "
                      "machine looks slower",
                      simulated, pace)};
}

}  // namespace

int plan(const PlanOptions& options) {
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
  if (!speed) speed = calibrate(design, usual_folder(design));
  std::cout << plan_text(design, speed, spread, options.workers > 0 ? options.workers : processors())
            << remark;
  return done;
}

}  // namespace commands

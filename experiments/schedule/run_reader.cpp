#include "experiments/schedule/run_reader.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "experiments/schedule/nearest.h"

namespace schedule {
namespace {

constexpr int pairs_for_an_error = 25;  // 50 games: coverage .947 to .955 (reference table of [S] in harness)

/// A word that stands for one of some values.
template <class Value>
std::optional<Value> read_choice(TomlTable& table, const std::string& key,
                                 const std::vector<std::pair<std::string, Value>>& known) {
  const auto word = table.text(key);
  if (!word) return std::nullopt;
  std::vector<std::string> names;
  std::string list;
  for (const auto& [name, value] : known) {
    if (name == *word) return value;
    names.push_back(name);
    list += (list.empty() ? "" : ", ") + name;
  }
  table.reject(key, "there is no such one" + did_you_mean(*word, names) + "; known are: " + list);
}

enum class Range { Positive, OpenShare, Share, Signed };

void read_number(TomlTable& table, const std::string& key, Range range, double most, double& value) {
  const auto number = table.number(key);
  if (!number) return;
  const std::string top = std::to_string(static_cast<long>(most));
  switch (range) {
    case Range::Positive:
      if (!(*number > 0 && *number <= most)) table.reject(key, "must be above 0 and at most " + top);
      break;
    case Range::OpenShare:
      if (!(*number > 0 && *number < most)) {
        table.reject(key, "must be above 0 and below " + std::string(most < 1 ? "0.5" : "1"));
      }
      break;
    case Range::Share:
      if (!(*number >= 0 && *number <= 1)) table.reject(key, "must be from 0 to 1");
      break;
    case Range::Signed:
      if (!(*number >= -most && *number <= most)) table.reject(key, "must be from -" + top + " to " + top);
      break;
  }
  value = *number;
}

template <class Integer>
void read_integer(TomlTable& table, const std::string& key, std::int64_t least, std::int64_t most,
                  Integer& value) {
  const auto number = table.integer(key);
  if (!number) return;
  if (*number < least || *number > most) {
    table.reject(key, "must be from " + std::to_string(least) + " to " + std::to_string(most));
  }
  value = static_cast<Integer>(*number);
}

void read_precision(TomlTable& table, Stopping& stopping) {
  if (!table.has("standard_error")) {
    table.missing("standard_error", "give the standard error to be reached [goals a game], as 0.1");
  }
  read_number(table, "standard_error", Range::Positive, 100, stopping.standard_error);
  stopping.minimum_pairs = pairs_for_an_error;
}

void read_hypotheses(TomlTable& table, Stopping& stopping) {
  const std::vector<std::pair<std::string, Metric>> metrics{{"goal-difference", Metric::GoalDifference},
                                                            {"points", Metric::Points}};
  stopping.metric = read_choice(table, "metric", metrics).value_or(Metric::GoalDifference);
  constexpr double most = 10;  // standard deviations
  read_number(table, "h0", Range::Signed, most, stopping.h0);
  read_number(table, "h1", Range::Signed, most, stopping.h1);
  constexpr double most_points = 2;  // nine games in ten won; beyond it the first look decides anyway
  if (stopping.metric == Metric::Points && !(stopping.h1 <= most_points && stopping.h0 >= -most_points)) {
    table.reject(table.has("h1") ? "h1" : "h0",
                 "must be from -2 to 2 for points, in standard deviations of a game");
  }
  if (!(stopping.h0 < stopping.h1)) {
    table.reject(table.has("h1") ? "h1" : "h0",
                 "h0 must be below h1, as 0 and 0.2: h1 says by how much A is better, in standard deviations "
                 "of a game");
  }
  constexpr double least_distance = 1e-3;  // ours: between nearer ones no test decides within most_pairs
  if (stopping.h1 - stopping.h0 < least_distance) {
    table.reject(table.has("h1") ? "h1" : "h0", "h1 must be above h0 by at least 0.001");
  }
  constexpr double least_chance = 1e-6;  // ours: nobody plays so many games that it could be seen
  for (const auto& [key, value] : {std::pair{"alpha", &stopping.alpha}, std::pair{"beta", &stopping.beta}}) {
    read_number(table, key, Range::OpenShare, 0.5, *value);
    if (*value < least_chance) table.reject(key, "must be at least 0.000001");
  }
  double clip = 0;
  read_number(table, "clip", Range::Positive, 100, clip);
  if (clip > 0 && stopping.metric == Metric::Points) table.reject("clip", "is for the goal difference only");
  if (clip > 0) stopping.clip = clip;
}

}  // namespace

Stopping read_stopping(TomlTable& root, int pairs) {
  Stopping stopping;
  auto table = root.table("stopping");
  if (!table) return stopping;
  const std::vector<std::pair<std::string, StopRule>> rules{
      {"fixed", StopRule::Fixed}, {"precision", StopRule::Precision}, {"sequential", StopRule::Sequential}};
  const auto rule = read_choice(*table, "rule", rules);
  if (!rule) table->missing("rule", "give fixed, precision or sequential");
  stopping.rule = *rule;
  if (stopping.rule == StopRule::Precision) read_precision(*table, stopping);
  if (stopping.rule == StopRule::Sequential) read_hypotheses(*table, stopping);
  if (stopping.rule != StopRule::Fixed && pairs < 2) {
    table->reject("rule",
                  "needs at least two pairs, since one has no spread; give pairs = 2 or more, or leave out "
                  "[stopping]");
  }
  if (stopping.rule != StopRule::Fixed) {
    if (stopping.minimum_pairs > pairs) stopping.minimum_pairs = pairs;
    read_integer(*table, "minimum_pairs", 2, pairs, stopping.minimum_pairs);
    read_integer(*table, "batch_pairs", 1, pairs, stopping.batch_pairs);
  }
  table->finish();
  return stopping;
}

namespace {

/// "60 s"
std::string text(double seconds) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%g s", seconds);
  return text.data();
}

/// Whoever is above what follows is at fault before a watchdog, which blames nobody, ends the game.
void read_team_time(TomlTable& table, double longest, Limits& limits) {
  TeamTime& time = limits.team_time = usual_team_time(limits.silence, limits.game);
  const auto check = [&](const char* key, double value, const char* watchdog, double after) {
    if (2 * value < after) return;
    table.reject(key, "two teams may then take " + text(2 * value) + ", and after " + text(after) + " (" +
                          watchdog + ") the game is void: must be below half of it");
  };
  read_number(table, "team_second", Range::Positive, longest, time.second);
  check("team_second", time.second, "silence", limits.silence);
  read_number(table, "team_game", Range::Positive, longest, time.game);
  check("team_game", time.game, "game", limits.game);
  time.reply = std::min(time.reply, time.second);
  read_number(table, "team_reply", Range::Positive, longest, time.reply);
  if (time.reply > time.second) {
    table.reject("team_reply", "is more than the " + text(time.second) +
                                   " allowed for a whole simulated second (team_second)");
  }
}

}  // namespace

Limits read_limits(TomlTable& root) {
  Limits limits;
  auto table = root.table("limits");
  if (!table) return limits;
  constexpr double longest = 1e6;            // [s] eleven days
  constexpr std::int64_t largest = 1 << 24;  // [MiB] 16 TiB
  read_number(*table, "silence", Range::Positive, longest, limits.silence);
  read_number(*table, "game", Range::Positive, longest, limits.game);
  read_team_time(*table, longest, limits);
  read_number(*table, "build", Range::Positive, longest, limits.build);
  read_integer(*table, "team_memory", 1, largest, limits.team_memory);
  read_integer(*table, "output", 0, largest, limits.output);
  read_integer(*table, "kept_logs", 0, largest, limits.kept_logs);
  read_integer(*table, "free_disk", 0, largest, limits.free_disk);
  read_integer(*table, "faults_in_a_row", 1, 1'000'000, limits.faults_in_a_row);
  read_number(*table, "fault_share", Range::Share, 1, limits.fault_share);
  read_number(*table, "sampled", Range::Share, 1, limits.sampled);
  read_number(*table, "audited", Range::Share, 1, limits.audited);
  table->finish();
  return limits;
}

}  // namespace schedule

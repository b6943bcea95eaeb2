#include <stdexcept>

#include "experiments/record/json_fields.h"
#include "experiments/record/json_text.h"
#include "experiments/record/match_config.h"
#include "experiments/record/match_record.h"

namespace record {
namespace {

// Ranges of what a game can give, ours: far above any game, and far below what arithmetic could not hold. A
// game has at most 40 simulated minutes, 80 with a winner.
constexpr int most_goals = 1'000;               // one in 2.4 s
constexpr int most_counted = 10'000'000;        // of anything, seventy a tick of such a game
constexpr std::int64_t most_ticks = 1'000'000;  // 4.6 hours
constexpr double most_seconds = 1e6;            // simulated, or of a processor: 11 days
constexpr double most_metres = 1e7;
constexpr double most_of_anything = 1e15;                       // bytes, nanoseconds
constexpr std::int64_t most_nanoseconds = 100'000'000'000'000;  // 28 hours

Json team_json(const TeamConfig& team) {
  Json json{{"name", team.name},
            {"command", team.command},
            {"robots", team.robots},
            {"speed_factor", team.speed_factor}};
  if (!team.directory.empty()) json["directory"] = team.directory.string();
  return json;
}

TeamConfig team_from(const Json& json, const std::string& what) {
  const Fields fields(json, what);
  TeamConfig team;
  fields.read("name", team.name);
  fields.read("command", team.command);
  fields.read("robots", team.robots);
  team.speed_factor = fields.real("speed_factor", 0, 1);
  if (fields.has("directory")) team.directory = fields.text("directory");
  return team;
}

world::Team colour_from(const Fields& fields, const char* key) {
  const std::string word = fields.text(key);
  for (const world::Team team : world::both_teams) {
    if (word == world::name(team)) return team;
  }
  throw std::invalid_argument(fields.name_of(key) + " must be yellow or blue, not '" + word + "'");
}

template <class T>
Json per_team_json(const world::PerTeam<T>& value) {
  return Json{{"yellow", value.yellow}, {"blue", value.blue}};
}

void read_per_team(const Fields& fields, const char* key, world::PerTeam<std::string>& value) {
  const Fields inner(fields.at(key), fields.name_of(key));
  for (const world::Team team : world::both_teams) inner.read(world::name(team), value[team]);
}

world::PerTeam<int> counts_from(const Fields& fields, const char* key, int most) {
  const Fields inner(fields.at(key), fields.name_of(key));
  return {.yellow = inner.count("yellow", most), .blue = inner.count("blue", most)};
}

std::map<std::string, int> kinds_from(const Fields& fields, const char* key) {
  const Fields inner(fields.at(key), fields.name_of(key));
  std::map<std::string, int> kinds;
  inner.each([&](const std::string& kind) { kinds[kind] = inner.count(kind.c_str(), most_counted); });
  return kinds;
}

std::map<std::string, double> numbers_from(const Fields& fields, const char* key) {
  const Fields inner(fields.at(key), fields.name_of(key));
  std::map<std::string, double> numbers;
  inner.each([&](const std::string& name) {
    numbers[name] = inner.real(name.c_str(), -most_of_anything, most_of_anything);
  });
  return numbers;
}

Json call_json(const CallEntry& call) {
  return Json{{"ns", call.time.time_since_epoch().count()},
              {"row", call.row},
              {"event", call.event},
              {"command", call.command},
              {"restart", call.restart},
              {"sentence", call.sentence}};
}

CallEntry call_from(const Json& json) {
  const Fields fields(json, "call");
  CallEntry call;
  call.time = world::Time{world::Duration{fields.integer("ns", -most_nanoseconds, most_nanoseconds)}};
  fields.read("row", call.row);
  fields.read("event", call.event);
  fields.read("command", call.command);
  fields.read("restart", call.restart);
  fields.read("sentence", call.sentence);
  return call;
}

Json team_statistics_json(const TeamStatistics& team) {
  return Json{{"kicks", team.kicks},
              {"shots", team.shots},
              {"shots_on_target", team.shots_on_target},
              {"saves", team.saves},
              {"passes", team.passes},
              {"passes_completed", team.passes_completed},
              {"touches", team.touches},
              {"turnovers", team.turnovers},
              {"balls_out", team.balls_out},
              {"possession", team.possession},
              {"territory", team.territory},
              {"distance", team.distance}};
}

TeamStatistics team_statistics_from(const Json& json, const std::string& what) {
  const Fields fields(json, what);
  TeamStatistics team;
  team.kicks = fields.count("kicks", most_counted);
  team.shots = fields.count("shots", most_counted);
  team.shots_on_target = fields.count("shots_on_target", most_counted);
  team.saves = fields.count("saves", most_counted);
  team.passes = fields.count("passes", most_counted);
  team.passes_completed = fields.count("passes_completed", most_counted);
  team.touches = fields.count("touches", most_counted);
  team.turnovers = fields.count("turnovers", most_counted);
  team.balls_out = fields.count("balls_out", most_counted);
  team.possession = fields.real("possession", 0, most_seconds);
  team.territory = fields.real("territory", 0, most_seconds);
  team.distance = fields.real("distance", 0, most_metres);
  return team;
}

Json statistics_json(const MatchStatistics& game) {
  return Json{{"time", game.time},
              {"in_play", game.in_play},
              {"passages", game.passages},
              {"longest_passage", game.longest_passage},
              {"yellow", team_statistics_json(game.teams.yellow)},
              {"blue", team_statistics_json(game.teams.blue)}};
}

MatchStatistics statistics_from(const Json& json, const std::string& what) {
  const Fields fields(json, what);
  MatchStatistics game;
  game.time = fields.real("time", 0, most_seconds);
  game.in_play = fields.real("in_play", 0, most_seconds);
  game.passages = fields.count("passages", most_counted);
  game.longest_passage = fields.real("longest_passage", 0, most_seconds);
  for (const world::Team team : world::both_teams) {
    game.teams[team] = team_statistics_from(fields.at(world::name(team)), fields.name_of(world::name(team)));
  }
  return game;
}

}  // namespace

std::string quoted(std::string_view text) { return dumped(Json(std::string(text))); }
std::string number(double value) { return dumped(Json(value)); }
std::string to_json(const TeamConfig& team) { return dumped(team_json(team)); }

std::string to_json(const RealismConfig& realism) {
  return dumped(Json{{"preset", realism.preset}, {"changes", realism.changes}});
}

std::string text(const RealismConfig& realism) {
  constexpr std::size_t most_told = 4;
  if (realism.changes.size() > most_told) {
    return realism.preset + " with " + std::to_string(realism.changes.size()) + " numbers of its own";
  }
  std::string text = realism.preset;
  for (const auto& [key, value] : realism.changes) {
    text += (text == realism.preset ? " with " : ", ") + key + " " + number(value);
  }
  return text;
}

std::string to_json(const MatchConfig& config) {
  Json json{{"yellow", team_json(config.teams.yellow)},
            {"blue", team_json(config.teams.blue)},
            {"seed", config.seed},
            {"rules", config.rules},
            {"realism", config.realism.preset},
            {"realism_changes", config.realism.changes},
            {"half_length", nullptr},
            {"winner", config.winner},
            {"blue_on_positive_half", config.blue_on_positive_half},
            {"first_kickoff", world::name(config.first_kickoff)},
            {"continuation", nullptr},
            {"recording", nullptr},
            {"log", nullptr},
            {"directory", config.directory.string()}};
  if (config.half_length) json["half_length"] = *config.half_length;
  if (config.continuation) {
    json["continuation"] = {{"recording", config.continuation->recording.string()}, {"tick", nullptr}};
    if (config.continuation->tick) json["continuation"]["tick"] = *config.continuation->tick;
  }
  if (config.recording) json["recording"] = config.recording->string();
  if (config.log) json["log"] = config.log->string();
  return dumped(json);
}

MatchConfig match_config_from_json(const std::string& text) {
  const Json json = parsed(text, "match configuration");
  const Fields fields(json, "match configuration");
  MatchConfig config;
  config.teams.yellow = team_from(fields.at("yellow"), fields.name_of("yellow"));
  config.teams.blue = team_from(fields.at("blue"), fields.name_of("blue"));
  config.seed = fields.seed("seed");
  fields.read("rules", config.rules);
  fields.read("realism", config.realism.preset);
  config.realism.changes = numbers_from(fields, "realism_changes");
  if (fields.has("half_length")) config.half_length = fields.real("half_length", 0, most_seconds);
  if (fields.has("winner")) fields.read("winner", config.winner);
  fields.read("blue_on_positive_half", config.blue_on_positive_half);
  config.first_kickoff = colour_from(fields, "first_kickoff");
  if (fields.has("continuation")) {
    const Fields inner(fields.at("continuation"), fields.name_of("continuation"));
    Continuation& continuation = config.continuation.emplace();
    continuation.recording = inner.text("recording");
    if (inner.has("tick")) continuation.tick = inner.integer("tick", 0, most_ticks);
  }
  if (fields.has("recording")) config.recording = fields.text("recording");
  if (fields.has("log")) config.log = fields.text("log");
  config.directory = fields.text("directory");
  return config;
}

std::string to_json(const MatchRecord& record) {
  Json timeline = Json::array();
  for (const CallEntry& call : record.timeline) timeline.push_back(call_json(call));
  Json statistics = nullptr;
  if (record.statistics) statistics = statistics_json(*record.statistics);
  return dumped(Json{{"goals", per_team_json(record.goals)},
                     {"termination", name(record.termination)},
                     {"at_fault", name(record.at_fault)},
                     {"reason", record.reason},
                     {"ticks", record.ticks},
                     {"hash", record.hash},
                     {"calls", record.calls},
                     {"fouls", per_team_json(record.fouls)},
                     {"fouls_by_kind", per_team_json(record.fouls_by_kind)},
                     {"stoppages", record.stoppages},
                     {"counters", record.counters},
                     {"statistics", statistics},
                     {"versions", per_team_json(record.versions)},
                     {"timeline", timeline},
                     {"wall_seconds", record.wall_seconds},
                     {"costs", record.costs}});
}

MatchRecord match_record_from_json(const std::string& text, Timeline timeline) {
  const Json json = parsed(text, "match record", timeline == Timeline::Skip ? "timeline" : nullptr);
  const Fields fields(json, "match record");
  MatchRecord record;
  record.goals = counts_from(fields, "goals", most_goals);
  record.termination = termination_from_name(fields.text("termination"));
  record.at_fault = party_from_name(fields.text("at_fault"));
  fields.read("reason", record.reason);
  record.ticks = fields.integer("ticks", 0, most_ticks);
  fields.read("hash", record.hash);
  record.calls = kinds_from(fields, "calls");
  record.fouls = counts_from(fields, "fouls", most_counted);
  // Ledgers of schema 1 have neither of these two.
  if (fields.has("fouls_by_kind")) {
    const Fields inner(fields.at("fouls_by_kind"), fields.name_of("fouls_by_kind"));
    for (const world::Team team : world::both_teams) {
      record.fouls_by_kind[team] = kinds_from(inner, world::name(team));
    }
  }
  if (fields.has("statistics")) {
    record.statistics = statistics_from(fields.at("statistics"), fields.name_of("statistics"));
  }
  record.stoppages = fields.count("stoppages", most_counted);
  record.counters = numbers_from(fields, "counters");
  read_per_team(fields, "versions", record.versions);
  if (timeline == Timeline::Read) {
    const Json& calls = fields.at("timeline");
    if (!calls.is_array()) throw std::invalid_argument(fields.name_of("timeline") + " is not a list");
    for (const Json& call : calls) record.timeline.push_back(call_from(call));
  }
  record.wall_seconds = fields.real("wall_seconds", 0, most_seconds);
  record.costs = numbers_from(fields, "costs");
  return record;
}

}  // namespace record

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "experiments/record/json_text.h"
#include "experiments/record/match_config.h"
#include "experiments/record/match_record.h"

namespace record {
namespace {

using Json = nlohmann::ordered_json;

// The log of a program may hold any bytes; a record must still be written.
std::string dumped(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

Json parsed(const std::string& text, const char* what) {
  try {
    Json json = Json::parse(text);
    if (!json.is_object()) throw std::invalid_argument(std::string(what) + ": not a JSON object");
    return json;
  } catch (const Json::exception& error) {
    throw std::invalid_argument(std::string(what) + ": not JSON: " + error.what());
  }
}

/// Reads fields and says which one was wrong.
class Fields {
 public:
  Fields(const Json& json, std::string what) : json_(json), what_(std::move(what)) {
    if (!json_.is_object()) throw std::invalid_argument(what_ + ": not a JSON object");
  }
  const Json& at(const char* key) const {
    const auto found = json_.find(key);
    if (found == json_.end()) throw std::invalid_argument(what_ + ": field '" + key + "' is missing");
    return *found;
  }
  bool has(const char* key) const {
    const auto found = json_.find(key);
    return found != json_.end() && !found->is_null();
  }
  template <class T>
  void read(const char* key, T& value) const {
    const Json& field = at(key);
    try {
      field.get_to(value);
    } catch (const Json::exception&) {
      throw std::invalid_argument(what_ + ": field '" + key + "' has the wrong type: " + dumped(field));
    }
  }
  std::string text(const char* key) const {
    std::string value;
    read(key, value);
    return value;
  }
  std::string name_of(const char* key) const { return what_ + ": field '" + key + "'"; }

 private:
  const Json& json_;
  std::string what_;
};

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
  fields.read("speed_factor", team.speed_factor);
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

template <class T>
void read_per_team(const Fields& fields, const char* key, world::PerTeam<T>& value) {
  const Fields inner(fields.at(key), fields.name_of(key));
  inner.read("yellow", value.yellow);
  inner.read("blue", value.blue);
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
  std::int64_t nanoseconds = 0;
  fields.read("ns", nanoseconds);
  call.time = world::Time{world::Duration{nanoseconds}};
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
  fields.read("kicks", team.kicks);
  fields.read("shots", team.shots);
  fields.read("shots_on_target", team.shots_on_target);
  fields.read("saves", team.saves);
  fields.read("passes", team.passes);
  fields.read("passes_completed", team.passes_completed);
  fields.read("touches", team.touches);
  fields.read("turnovers", team.turnovers);
  fields.read("balls_out", team.balls_out);
  fields.read("possession", team.possession);
  fields.read("territory", team.territory);
  fields.read("distance", team.distance);
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
  fields.read("time", game.time);
  fields.read("in_play", game.in_play);
  fields.read("passages", game.passages);
  fields.read("longest_passage", game.longest_passage);
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
  fields.read("seed", config.seed);
  fields.read("rules", config.rules);
  fields.read("realism", config.realism.preset);
  fields.read("realism_changes", config.realism.changes);
  if (fields.has("half_length")) {
    double half_length = 0;
    fields.read("half_length", half_length);
    config.half_length = half_length;
  }
  if (fields.has("winner")) fields.read("winner", config.winner);
  fields.read("blue_on_positive_half", config.blue_on_positive_half);
  config.first_kickoff = colour_from(fields, "first_kickoff");
  if (fields.has("continuation")) {
    const Fields inner(fields.at("continuation"), fields.name_of("continuation"));
    Continuation& continuation = config.continuation.emplace();
    continuation.recording = inner.text("recording");
    if (inner.has("tick")) inner.read("tick", continuation.tick.emplace());
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

MatchRecord match_record_from_json(const std::string& text) {
  const Json json = parsed(text, "match record");
  const Fields fields(json, "match record");
  MatchRecord record;
  read_per_team(fields, "goals", record.goals);
  record.termination = termination_from_name(fields.text("termination"));
  record.at_fault = party_from_name(fields.text("at_fault"));
  fields.read("reason", record.reason);
  fields.read("ticks", record.ticks);
  fields.read("hash", record.hash);
  fields.read("calls", record.calls);
  read_per_team(fields, "fouls", record.fouls);
  // Ledgers of schema 1 have neither of these two.
  if (fields.has("fouls_by_kind")) read_per_team(fields, "fouls_by_kind", record.fouls_by_kind);
  if (fields.has("statistics")) {
    record.statistics = statistics_from(fields.at("statistics"), fields.name_of("statistics"));
  }
  fields.read("stoppages", record.stoppages);
  fields.read("counters", record.counters);
  read_per_team(fields, "versions", record.versions);
  for (const Json& call : fields.at("timeline")) record.timeline.push_back(call_from(call));
  fields.read("wall_seconds", record.wall_seconds);
  fields.read("costs", record.costs);
  return record;
}

}  // namespace record

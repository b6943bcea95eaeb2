#include "experiments/judge/state_text.h"

#include <limits>
#include <stdexcept>

#include "experiments/judge/json_values.h"

namespace judge {
namespace {

using world::Team;

constexpr int last_stage = static_cast<int>(world::Stage::Post);
constexpr int last_location = static_cast<int>(world::Location::Break);
constexpr int last_command = static_cast<int>(world::CommandKind::Timeout);

/// The value of an enumeration that has that name.
template <class Value>
Value named(const Json& json, int last) {
  const std::string text = json.get<std::string>();
  for (int n = 0; n <= last; ++n) {
    if (text == world::name(static_cast<Value>(n))) return static_cast<Value>(n);
  }
  throw std::invalid_argument("a game state cannot say '" + text.substr(0, 60) + "'");
}

Team team_in(const Json& json) { return named<Team>(json, static_cast<int>(Team::Blue)); }

template <class Value>
Json pair_of(const world::PerTeam<Value>& both) {
  return Json::array({both.yellow, both.blue});
}
world::PerTeam<int> pair_in(const Json& json, int most) {
  return {static_cast<int>(whole_in(json.at(0), 0, most)), static_cast<int>(whole_in(json.at(1), 0, most))};
}
constexpr int most_cards = 1000;  // ours: one every two seconds of a game

}  // namespace

std::string state_text(const world::GameState& state) {
  Json json;
  json["location"] = world::name(state.location);
  json["since"] = ns(state.location_time);
  json["stage"] = world::name(state.stage);
  json["command"] = world::name(state.command.kind);
  json["command_team"] = world::name(state.command.team);
  json["command_counter"] = state.command_counter;
  json["command_time"] = ns(state.command_time);
  json["call"] = world::name(state.call);
  json["restart"] = world::name(state.restart);
  json["kick_team"] = world::name(state.kick_team);
  json["goal_allowed"] = state.goal_allowed;
  json["is_kickoff"] = state.is_kickoff;
  json["blue_on_positive_half"] = state.blue_on_positive_half;
  json["keeper"] = pair_of(state.keeper);
  json["red_cards"] = pair_of(state.red_cards);
  json["yellow_cards_now"] = Json::array({state.yellow_times.yellow.size(), state.yellow_times.blue.size()});
  json["halted"] = state.halted;
  if (state.touch_team) json["touch_team"] = world::name(*state.touch_team);
  if (state.last_touch) {
    json["last_touch"] = touch_of(state.last_touch);
    json["last_touch_at"] = place_of(state.last_touch->position);
  }
  if (state.kicker) json["kicker"] = text_of(*state.kicker);
  if (state.kick_position) json["kick_position"] = place_of(*state.kick_position);
  if (state.reset_position) json["reset_position"] = place_of(*state.reset_position);
  if (state.penalty) {
    Json& its = json["penalty"];
    its["taken"] = ns(state.penalty->taken);
    if (state.penalty->attacker) its["attacker"] = text_of(*state.penalty->attacker);
    if (state.penalty->defender) its["defender"] = text_of(*state.penalty->defender);
  }
  return json.dump();
}

world::GameState state_in(const std::string& text) {
  const Json json = Json::parse(text);
  world::GameState state;
  state.location = named<world::Location>(json.at("location"), last_location);
  state.location_time = time_in(json.at("since"));
  state.stage = named<world::Stage>(json.at("stage"), last_stage);
  state.command.kind = named<world::CommandKind>(json.at("command"), last_command);
  state.command.team = team_in(json.at("command_team"));
  state.command_counter = static_cast<std::uint32_t>(
      whole_in(json.at("command_counter"), 0, std::numeric_limits<std::uint32_t>::max()));
  state.command_time = time_in(json.at("command_time"));
  state.call = named<world::CommandKind>(json.at("call"), last_command);
  state.restart = named<world::CommandKind>(json.at("restart"), last_command);
  state.kick_team = team_in(json.at("kick_team"));
  state.goal_allowed = json.at("goal_allowed").get<bool>();
  state.is_kickoff = json.at("is_kickoff").get<bool>();
  state.blue_on_positive_half = json.at("blue_on_positive_half").get<bool>();
  state.keeper = pair_in(json.at("keeper"), world::max_robot_number);
  state.red_cards = pair_in(json.at("red_cards"), most_cards);
  const world::PerTeam<int> yellow = pair_in(json.at("yellow_cards_now"), most_cards);
  for (const Team team : world::both_teams) {
    state.yellow_times[team].resize(static_cast<std::size_t>(yellow[team]), std::chrono::seconds{120});
  }
  state.halted = json.at("halted").get<bool>();
  if (json.contains("touch_team")) state.touch_team = team_in(json.at("touch_team"));
  if (json.contains("last_touch")) {
    state.last_touch = touch_in(json.at("last_touch"));
    if (!state.last_touch) throw std::invalid_argument("the last touch is null");
    state.last_touch->position = place_in(json.at("last_touch_at"));
  }
  if (json.contains("kicker")) state.kicker = robot_in(json.at("kicker").get<std::string>());
  if (json.contains("kick_position")) state.kick_position = place_in(json.at("kick_position"));
  if (json.contains("reset_position")) state.reset_position = place_in(json.at("reset_position"));
  if (json.contains("penalty")) {
    const Json& its = json.at("penalty");
    state.penalty.emplace();
    state.penalty->taken = time_in(its.at("taken"));
    if (its.contains("attacker")) state.penalty->attacker = robot_in(its.at("attacker").get<std::string>());
    if (its.contains("defender")) state.penalty->defender = robot_in(its.at("defender").get<std::string>());
  }
  return state;
}

}  // namespace judge

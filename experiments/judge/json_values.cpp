#include "experiments/judge/json_values.h"

#include <stdexcept>

namespace judge {

std::string text_of(world::RobotId id) {
  return (id.team == world::Team::Yellow ? "Y" : "B") + std::to_string(id.number);
}
world::RobotId robot_in(const std::string& text) {
  if (text.size() < 2 || (text[0] != 'Y' && text[0] != 'B')) throw std::invalid_argument("no robot: " + text);
  return {text[0] == 'Y' ? world::Team::Yellow : world::Team::Blue,
          static_cast<std::uint8_t>(std::stoi(text.substr(1)))};
}

Json touch_of(const std::optional<world::Touch>& touch) {
  if (!touch) return nullptr;
  return Json::array({text_of(touch->robot), ns(touch->time), touch->probability});
}
std::optional<world::Touch> touch_in(const Json& json) {
  if (json.is_null()) return std::nullopt;
  world::Touch touch;
  touch.robot = robot_in(json.at(0).get<std::string>());
  touch.time = time_in(json.at(1));
  touch.probability = json.at(2).get<double>();
  return touch;
}

Json json_of(const TrueEvent& truth) {
  Json json;
  json["time"] = ns(truth.time);
  if (truth.until) json["until"] = ns(*truth.until);
  if (truth.clear) json["clear"] = ns(*truth.clear);
  json["margin"] = truth.margin;
  json["value"] = truth.value;
  if (truth.by) json["by"] = text_of(*truth.by);
  json["place"] = place_of(truth.place);
  if (truth.ambiguous) json["ambiguous"] = true;
  if (truth.over_goal) json["over_goal"] = true;
  if (truth.late) json["late"] = true;
  if (!truth.last) return json;
  Json last;
  last["robot"] = text_of(truth.last->robot);
  last["time"] = ns(truth.last->time);
  last["kind"] = name(truth.last->kind);
  if (truth.last->chip) last["chip"] = true;
  if (truth.last->crowded) last["crowded"] = true;
  if (truth.last->at_line) last["at_line"] = true;
  last["impulse"] = truth.last->impulse;
  last["alone"] = truth.last->alone;
  last["lost"] = truth.last->lost;
  json["last"] = std::move(last);
  return json;
}

TrueEvent truth_in(const Json& json, Event event) {
  TrueEvent truth;
  truth.event = event;
  truth.time = time_in(json.at("time"));
  if (json.contains("until")) truth.until = time_in(json.at("until"));
  if (json.contains("clear")) truth.clear = time_in(json.at("clear"));
  truth.margin = json.at("margin").get<double>();
  truth.value = json.at("value").get<double>();
  if (json.contains("by")) truth.by = robot_in(json.at("by").get<std::string>());
  truth.place = place_in(json.at("place"));
  truth.ambiguous = json.value("ambiguous", false);
  truth.over_goal = json.value("over_goal", false);
  truth.late = json.value("late", false);
  if (!json.contains("last")) return truth;
  const Json& its = json.at("last");
  LastTouch last;
  last.robot = robot_in(its.at("robot").get<std::string>());
  last.time = time_in(its.at("time"));
  const auto kind = kind_named(its.at("kind").get<std::string>());
  if (!kind) throw std::invalid_argument("no kind of touch: " + its.at("kind").get<std::string>());
  last.kind = *kind;
  last.chip = its.value("chip", false);
  last.crowded = its.value("crowded", false);
  last.at_line = its.value("at_line", false);
  last.impulse = its.value("impulse", 0.0);
  last.alone = its.value("alone", 1e9);
  last.lost = its.at("lost").get<int>();
  truth.last = last;
  return truth;
}

}  // namespace judge

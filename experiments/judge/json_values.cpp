#include "experiments/judge/json_values.h"

#include <charconv>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace judge {
namespace {

constexpr double largest = 1e15;
constexpr double farthest = 1000;                       // [m]
constexpr std::int64_t latest = 1'000'000'000'000'000;  // [ns]
constexpr std::size_t longest_shown = 60;               // of a value in a message
constexpr std::uint64_t most_signed = std::numeric_limits<std::int64_t>::max();

}  // namespace

std::string text_of(world::RobotId id) {
  return (id.team == world::Team::Yellow ? "Y" : "B") + std::to_string(id.number);
}
world::RobotId robot_in(const std::string& text) {
  int number = -1;
  if (text.size() >= 2 && (text[0] == 'Y' || text[0] == 'B')) {
    const char* end = text.data() + text.size();
    if (std::from_chars(text.data() + 1, end, number).ptr != end) number = -1;
  }
  if (number < 0 || number > world::max_robot_number) {
    throw std::invalid_argument("'" + text.substr(0, longest_shown) +
                                "' is no robot, Y0 to Y15 or B0 to B15");
  }
  return {text[0] == 'Y' ? world::Team::Yellow : world::Team::Blue, static_cast<std::uint8_t>(number)};
}

std::int64_t whole_in(const Json& json, std::int64_t lowest, std::int64_t highest) {
  const bool fits =
      json.is_number_integer() && (!json.is_number_unsigned() || json.get<std::uint64_t>() <= most_signed);
  const std::int64_t value = fits ? json.get<std::int64_t>() : 0;
  if (!fits || value < lowest || value > highest) {
    throw std::invalid_argument(json.dump().substr(0, longest_shown) + " is no whole number from " +
                                std::to_string(lowest) + " to " + std::to_string(highest));
  }
  return value;
}

double number_in(const Json& json) {
  const double value = json.is_number() ? json.get<double>() : NAN;
  if (!(std::abs(value) <= largest)) {
    throw std::invalid_argument(json.dump().substr(0, longest_shown) + " is no number up to 1e15");
  }
  return value;
}

world::Time time_in(const Json& json) {
  return world::Time{world::Duration{whole_in(json, -latest, latest)}};
}

world::Vector2d place_in(const Json& json) {
  const world::Vector2d place(number_in(json.at(0)), number_in(json.at(1)));
  if (place.cwiseAbs().maxCoeff() > farthest) {
    throw std::invalid_argument(json.dump().substr(0, longest_shown) + " is no place, up to 1000 m away");
  }
  return place;
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
  touch.probability = number_in(json.at(2));
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
  truth.margin = number_in(json.at("margin"));
  truth.value = number_in(json.at("value"));
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
  if (!kind)
    throw std::invalid_argument("no kind of touch: " + its.at("kind").dump().substr(0, longest_shown));
  last.kind = *kind;
  last.chip = its.value("chip", false);
  last.crowded = its.value("crowded", false);
  last.at_line = its.value("at_line", false);
  if (its.contains("impulse")) last.impulse = number_in(its.at("impulse"));
  if (its.contains("alone")) last.alone = number_in(its.at("alone"));
  last.lost = count_in(its.at("lost"));
  truth.last = last;
  return truth;
}

}  // namespace judge

#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "experiments/judge/true_event.h"
#include "sim/world/tracked_frame.h"

namespace judge {

// The words of which the judge's files are made. Times are whole nanoseconds, robots are "Y3" and "B11".

using Json = nlohmann::ordered_json;

std::string text_of(world::RobotId id);
world::RobotId robot_in(const std::string& text);

inline std::int64_t ns(world::Time time) { return time.time_since_epoch().count(); }
inline world::Time time_in(const Json& json) {
  return world::Time{world::Duration{json.get<std::int64_t>()}};
}
inline Json place_of(const world::Vector2d& place) { return Json::array({place.x(), place.y()}); }
inline world::Vector2d place_in(const Json& json) {
  return {json.at(0).get<double>(), json.at(1).get<double>()};
}

Json touch_of(const std::optional<world::Touch>& touch);
std::optional<world::Touch> touch_in(const Json& json);

Json json_of(const TrueEvent& truth);
TrueEvent truth_in(const Json& json, Event event);

}  // namespace judge

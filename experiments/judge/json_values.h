#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "experiments/judge/true_event.h"
#include "sim/world/tracked_frame.h"

namespace judge {

// The words of which the judge's files are made. Times are whole nanoseconds, robots are "Y3" and "B11". What
// is read is checked: each throws std::invalid_argument naming the value.

using Json = nlohmann::ordered_json;

std::string text_of(world::RobotId id);
world::RobotId robot_in(const std::string& text);

/// A whole number from `lowest` to `highest`.
std::int64_t whole_in(const Json& json, std::int64_t lowest, std::int64_t highest);
/// A count.
inline int count_in(const Json& json) { return static_cast<int>(whole_in(json, 0, 1'000'000'000)); }
/// A number up to 1e15, which no quantity of a game comes near.
double number_in(const Json& json);

inline std::int64_t ns(world::Time time) { return time.time_since_epoch().count(); }
/// Up to eleven days: no game is as long, and sums of times fit.
world::Time time_in(const Json& json);
inline Json place_of(const world::Vector2d& place) { return Json::array({place.x(), place.y()}); }
/// Within a kilometre.
world::Vector2d place_in(const Json& json);

Json touch_of(const std::optional<world::Touch>& touch);
std::optional<world::Touch> touch_in(const Json& json);

Json json_of(const TrueEvent& truth);
TrueEvent truth_in(const Json& json, Event event);

}  // namespace judge

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "sim/engine/realism.h"
#include "sim/world/field.h"

namespace engine {
namespace {

// One key: the member it stands for is written once, as an expression over a Realism `r`.
#define KEY(name, unit, lowest, highest, whole, member, meaning)                            \
  RealismKey {                                                                              \
    name, unit, lowest, highest, whole, meaning,                                            \
        [](const Realism& r) { return static_cast<double>(r.member); },                     \
        [](Realism& r, double value) { r.member = static_cast<decltype(r.member)>(value); } \
  }
#define REAL(name, unit, lowest, highest, member, meaning) \
  KEY(name, unit, lowest, highest, false, member, meaning)
#define WHOLE(name, unit, lowest, highest, member, meaning) \
  KEY(name, unit, lowest, highest, true, member, meaning)

constexpr double pi = 3.14159265358979;

constexpr std::array keys = {
    WHOLE("vision.cameras", "", 1, 8, vision.cameras,
          "cameras over equal parts of the field, an even number or one"),
    REAL("vision.camera_height", "m", 1, 20, vision.camera_height, "height of the cameras"),
    REAL("vision.overlap", "m", 0, 5, vision.overlap,
         "how far a camera sees beyond the middle line to its neighbour"),
    WHOLE("vision.delay", "ticks", 0, 60, vision.delay, "from capture to arrival"),
    REAL("vision.ball_sigma", "m", 0, 0.1, vision.ball_sigma, "noise of a ball position, per axis"),
    REAL("vision.robot_sigma", "m", 0, 0.1, vision.robot_sigma, "noise of a robot position, per axis"),
    REAL("vision.orientation_sigma", "rad", 0, 1, vision.orientation_sigma, "noise of a robot's orientation"),
    REAL("vision.bias_sigma", "m", 0, 0.2, vision.bias_sigma,
         "constant offset of a camera in one game, per axis"),
    REAL("vision.area_sigma", "px", 0, 100, vision.area_sigma, "noise of a ball's area in pixels"),
    REAL("vision.ball_missing", "", 0, 1, vision.ball_missing,
         "chance that the ball is missing in one image"),
    REAL("vision.robot_missing", "", 0, 1, vision.robot_missing,
         "chance that a robot is missing in one image"),
    REAL("vision.visible_share", "", 0, 1, vision.visible_share,
         "a ball of which less than this share is visible is not seen; 0: no occlusion"),
    REAL("vision.ball_burst_start", "", 0, 1, vision.ball_burst_start,
         "chance in one image that a burst of ball losses begins"),
    REAL("vision.ball_burst_length", "images", 1, 1000, vision.ball_burst_length,
         "mean length of such a burst"),
    REAL("vision.robot_burst_start", "", 0, 1, vision.robot_burst_start, "the same for each robot"),
    REAL("vision.robot_burst_length", "images", 1, 1000, vision.robot_burst_length,
         "mean length of such a burst"),
    WHOLE("vision.regions", "", 0, 20, vision.regions, "poorly calibrated regions of each camera"),
    REAL("vision.region_radius", "m", 0.01, 5, vision.region_radius, "their radius"),
    REAL("vision.region_missing", "", 0, 1, vision.region_missing,
         "chance that a ball in one is missing in one image"),
    REAL("vision.region_offset", "m", 0, 0.5, vision.region_offset,
         "error of positions in the middle of one"),
    REAL("vision.false_ball_rate", "1/s", 0, 10, vision.false_ball_rate, "false balls of each camera"),
    WHOLE("vision.false_ball_shortest", "images", 1, 1000, vision.false_ball_shortest,
          "how long one lasts at least"),
    WHOLE("vision.false_ball_longest", "images", 1, 1000, vision.false_ball_longest,
          "how long one lasts at most"),
    REAL("vision.misread_id", "", 0, 1, vision.misread_id,
         "chance in one image that a robot is given another number"),
    REAL("vision.unread_id", "", 0, 1, vision.unread_id,
         "chance in one image that a robot is given no number"),

    WHOLE("radio.latency", "ticks", 0, 60, radio.latency, "from command to effect"),
    REAL("radio.loss", "", 0, 1, radio.loss, "chance that a robot does not hear its command of one tick"),
    WHOLE("radio.timeout", "ticks", 0, 600, radio.timeout, "how long a robot that hears nothing goes on"),

    REAL("actuators.kick_direction_sigma", "rad", 0, 0.5, physics.actuators.kick_direction_sigma,
         "scatter of the direction of kicks"),
    REAL("actuators.kick_speed_sigma", "", 0, 0.5, physics.actuators.kick_speed_sigma,
         "scatter of the speed of kicks, a share of it"),
    REAL("actuators.chip_angle_sigma", "rad", 0, 0.5, physics.actuators.chip_angle_sigma,
         "scatter of the elevation of chips"),
    REAL("actuators.misfire", "", 0, 1, physics.actuators.misfire,
         "chance that a kick does not reach the ball"),
    REAL("actuators.grip_sigma", "", 0, 0.5, physics.actuators.grip_sigma,
         "scatter of the dribbler's grip at each capture, a share of it"),
    REAL("actuators.speed_sigma", "", 0, 0.3, physics.actuators.speed_sigma,
         "difference of a robot's speed from what was commanded, a share of it"),
    REAL("actuators.acceleration_sigma", "", 0, 0.3, physics.actuators.acceleration_sigma,
         "difference of a robot's acceleration from its limit, a share of it"),
    REAL("actuators.heading_drift_sigma", "rad/m", 0, 1, physics.actuators.heading_drift_sigma,
         "turn of a robot per metre driven"),

    REAL("ball.slide_deceleration", "m/s^2", 0.01, 50, physics.ball.slide_deceleration,
         "while the ball slides"),
    REAL("ball.roll_deceleration", "m/s^2", 0.001, 10, physics.ball.roll_deceleration, "while it rolls"),
    REAL("ball.restitution", "", 0, 1, physics.ball.restitution, "of a bounce on the carpet, vertical"),
    REAL("ball.bounce_friction", "", 0, 2, physics.ball.bounce_friction, "Coulomb friction during a bounce"),
    REAL("contact.ball_robot_restitution", "", 0, 1, physics.contact.ball_robot_restitution,
         "ball off a robot"),
    REAL("contact.ball_wall_restitution", "", 0, 1, physics.contact.ball_wall_restitution, "ball off a wall"),
    REAL("kicker.recharge", "s", 0, 60, physics.kicker.recharge, "between two kicks of a robot"),
    REAL("dribbler.pull", "m/s^2", 0, 50, physics.dribbler.pull,
         "largest acceleration of a held ball towards the robot"),
    REAL("dribbler.drag", "m/s^2", 0, 50, physics.dribbler.drag,
         "largest acceleration of a held ball sideways"),

    REAL("robots.mass", "kg", 0.1, 20, robots.mass, "of a robot"),
    REAL("robots.max_speed", "m/s", 0.1, 10, robots.max_speed, "forward and back"),
    REAL("robots.max_speed_sideways", "m/s", 0.1, 10, robots.max_speed_sideways, "sideways"),
    REAL("robots.max_acceleration", "m/s^2", 0.1, 50, robots.max_acceleration,
         "speeding up, forward and back"),
    REAL("robots.max_acceleration_sideways", "m/s^2", 0.1, 50, robots.max_acceleration_sideways,
         "speeding up, sideways"),
    REAL("robots.max_brake", "m/s^2", 0.1, 50, robots.max_brake, "slowing down, forward and back"),
    REAL("robots.max_brake_sideways", "m/s^2", 0.1, 50, robots.max_brake_sideways, "slowing down, sideways"),
    REAL("robots.max_angular_speed", "rad/s", 0.1, 100, robots.max_angular_speed, "turning"),
    REAL("robots.max_angular_acceleration", "rad/s^2", 0.1, 1000, robots.max_angular_acceleration,
         "turning faster"),
    REAL("robots.max_angular_brake", "rad/s^2", 0.1, 1000, robots.max_angular_brake, "turning slower"),
    REAL("robots.max_kick_speed", "m/s", 0.1, 10, robots.max_kick_speed, "of a flat kick"),
    REAL("robots.max_chip_speed", "m/s", 0.1, 7, robots.max_chip_speed, "of a chip, absolute"),
};

#undef WHOLE
#undef REAL
#undef KEY

// Levenshtein's distance, for the hint after a misspelt key.
std::size_t edits(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t changed = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({changed, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row[b.size()];
}

const RealismKey& find_key(std::string_view name) {
  const auto found =
      std::find_if(keys.begin(), keys.end(), [&](const auto& key) { return key.name == name; });
  if (found != keys.end()) return *found;
  const auto nearest = std::min_element(keys.begin(), keys.end(), [&](const auto& a, const auto& b) {
    return edits(name, a.name) < edits(name, b.name);
  });
  throw std::invalid_argument(fmt::format(
      "realism has no key \"{}\"; did you mean {}? `matchday realism` lists all", name, nearest->name));
}

}  // namespace

std::span<const RealismKey> realism_keys() { return keys; }

void set(Realism& realism, std::string_view name, double value) {
  const RealismKey& key = find_key(name);
  const std::string unit = key.unit.empty() ? "" : fmt::format(" {}", key.unit);
  if (!(value >= key.lowest && value <= key.highest)) {  // also not a number
    throw std::invalid_argument(
        fmt::format("realism {} = {}: must be from {} to {}{}", name, value, key.lowest, key.highest, unit));
  }
  if (key.whole && value != std::floor(value)) {
    throw std::invalid_argument(fmt::format("realism {} = {}: must be a whole number{}", name, value,
                                            unit.empty() ? "" : " of" + unit));
  }
  if (key.name == "vision.cameras")
    world::camera_grid({}, static_cast<int>(value), 1);  // says which are possible
  key.put(realism, value);
}

}  // namespace engine

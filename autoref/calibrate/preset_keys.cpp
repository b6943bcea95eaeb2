#include "autoref/calibrate/preset_keys.h"

#include <array>
#include <stdexcept>
#include <string>

namespace calibrate {
namespace {

constexpr std::array<PresetKey, 32> keys = {{
    {"vision.cameras", 1, 8, true},
    {"vision.camera_height", 1, 20, false},
    {"vision.overlap", 0, 5, false},
    {"vision.delay", 0, 60, true},
    {"vision.ball_sigma", 0, 0.1, false},
    {"vision.robot_sigma", 0, 0.1, false},
    {"vision.orientation_sigma", 0, 1, false},
    {"vision.bias_sigma", 0, 0.2, false},
    {"vision.area_sigma", 0, 100, false},
    {"vision.ball_missing", 0, 1, false},
    {"vision.robot_missing", 0, 1, false},
    {"vision.ball_burst_start", 0, 1, false},
    {"vision.ball_burst_length", 1, 1000, false},
    {"vision.robot_burst_start", 0, 1, false},
    {"vision.robot_burst_length", 1, 1000, false},
    {"vision.false_ball_rate", 0, 10, false},
    {"vision.false_ball_shortest", 1, 1000, true},
    {"vision.false_ball_longest", 1, 1000, true},
    {"vision.misread_id", 0, 1, false},
    {"vision.unread_id", 0, 1, false},
    {"ball.slide_deceleration", 0.01, 50, false},
    {"ball.roll_deceleration", 0.001, 10, false},
    {"robots.max_speed", 0.1, 10, false},
    {"robots.max_speed_sideways", 0.1, 10, false},
    {"robots.max_acceleration", 0.1, 50, false},
    {"robots.max_acceleration_sideways", 0.1, 50, false},
    {"robots.max_brake", 0.1, 50, false},
    {"robots.max_brake_sideways", 0.1, 50, false},
    {"robots.max_angular_speed", 0.1, 100, false},
    {"robots.max_angular_acceleration", 0.1, 1000, false},
    {"robots.max_angular_brake", 0.1, 1000, false},
    {"robots.max_kick_speed", 0.1, 10, false},
}};

}  // namespace

std::span<const PresetKey> preset_keys() { return keys; }

const PresetKey& preset_key(std::string_view name) {
  for (const PresetKey& key : keys) {
    if (key.name == name) return key;
  }
  throw std::invalid_argument("calibrate knows no key \"" + std::string(name) + "\"");
}

}  // namespace calibrate

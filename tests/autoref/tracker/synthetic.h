#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "sim/world/detection.h"
#include "sim/world/field.h"
#include "sim/world/random.h"
#include "sim/world/robot_id.h"

namespace synthetic {

using world::Vector2d;

/// Where everything is at one instant.
struct Scene {
  struct Robot {
    world::RobotId id;
    Vector2d position = Vector2d::Zero();
    double heading = 0;
  };
  std::optional<Vector2d> ball;
  std::vector<Robot> robots;
};

using Motion = std::function<Scene(double seconds)>;

/// Standard deviations of the preset `measured`.
struct Noise {
  double ball = 0.0005;     // [m]
  double robot = 0.00055;   // [m]
  double heading = 0.0035;  // [rad]
};
inline constexpr Noise no_noise{0, 0, 0};

/// Four cameras over the quarters that overlap by 0.6 m; camera c captures after substep c+1 of a tick.
class Cameras {
 public:
  explicit Cameras(Noise noise = {}, std::uint64_t seed = 1) : noise_(noise), stream_(seed, "cameras") {}

  /// The four images of the tick that ends at tick_time(tick).
  std::vector<world::Detection> images(std::int64_t tick, const Motion& motion);

 private:
  Noise noise_;
  world::RandomStream stream_;
};

/// A ball on the ground from its kick: slides at 3 m/s^2 to 5/7 of its speed, then rolls at 0.26 m/s^2 until
/// it stands; the closed form of football.md 2.4 with the defaults of world::Geometry.
struct GroundBall {
  Vector2d start = Vector2d::Zero();
  Vector2d kick = Vector2d::Zero();  // [m/s]
  bool slides = true;                // false: rolls from the start

  Vector2d position(double seconds) const;
  Vector2d velocity(double seconds) const;
};

/// A robot driven as in a game: every 0.3 to 1.5 s another velocity (up to 2.5 m/s) and turn (up to 8 rad/s),
/// speeding up by 3 m/s^2 and 50 rad/s^2, braking by 6 m/s^2 (world::RobotSpecs). Recorded at 1 kHz.
class GameRobot {
 public:
  GameRobot(std::uint64_t seed, double duration);
  Vector2d position(double seconds) const;
  Vector2d velocity(double seconds) const;
  double heading(double seconds) const;

 private:
  struct Sample {
    Vector2d position, velocity;
    double heading;
  };
  const Sample& at(double seconds) const;
  std::vector<Sample> samples_;
};

}  // namespace synthetic

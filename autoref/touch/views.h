#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "sim/world/detection.h"
#include "sim/world/field.h"
#include "sim/world/tracked_frame.h"

namespace touch {

using world::Vector2d;

inline constexpr std::size_t robot_slots = 2 * (world::max_robot_number + 1);

/// Yellow 0 to 15, then blue.
constexpr std::size_t slot(world::RobotId id) {
  return (id.team == world::Team::Yellow ? 0U : world::max_robot_number + 1U) + id.number;
}
constexpr world::RobotId robot_in(std::size_t slot) {
  constexpr std::size_t per_team = world::max_robot_number + 1;
  return {slot < per_team ? world::Team::Yellow : world::Team::Blue,
          static_cast<std::uint8_t>(slot % per_team)};
}

/// Ball and the robots round it in one image of one camera: what they are to each other has
/// no error of calibration.
struct Sighting {
  struct Robot {
    std::size_t slot = 0;
    Vector2d position = Vector2d::Zero();  ///< [m]
    double orientation = 0;                ///< [rad]
  };
  static constexpr std::size_t most_robots = 6;

  world::Time time;
  Vector2d ball = Vector2d::Zero();  ///< [m]
  std::array<Robot, most_robots> robots;
  std::size_t robot_count = 0;
  double gap = 1;           ///< [m] least, hull to ball
  std::size_t nearest = 0;  ///< whose; a slot

  const Robot* find(std::size_t slot) const {
    for (std::size_t n = 0; n < robot_count; ++n) {
      if (robots[n].slot == slot) return &robots[n];
    }
    return nullptr;
  }
};

/// A straight course through sightings clear of all robots, where none of them hides a part of the ball.
struct Course {
  static constexpr int samples = 4;
  world::Time time;                      ///< of the middle
  Vector2d middle = Vector2d::Zero();    ///< [m]
  Vector2d velocity = Vector2d::Zero();  ///< [m/s]
  double spread = 0;                     ///< [s^2] sum of the squared times from the middle
};

/// From the robot's hull, a circle with a flat front, to the ball's surface [m]; negative inside.
/// @param ball_local  [m] centre of the ball in the robot's frame, x to the front
double hull_gap(const Vector2d& ball_local, const world::Field& field);

/// The last sightings of one camera, newest first.
class View {
 public:
  static constexpr int window = 6;   ///< sightings that are judged at a time
  static constexpr int memory = 24;  ///< and kept

  int camera = -1;
  int followed = 0;              ///< sightings in a row, without a gap of 400 ms or a jump
  int clear = 0;                 ///< of them, the last ones farther than `clear_gap` from every robot
  std::optional<Course> course;  ///< of the last clear ones; stays while the ball is near robots

  const Sighting& operator[](int n) const { return ring_[static_cast<std::size_t>((newest_ + n) % memory)]; }
  /// Makes room for the newest one.
  Sighting& push(world::Time time, const Vector2d& ball);
  /// To be called when the sighting is complete.
  void finish(const world::Field& field);
  /// How many of them can be looked at.
  int kept() const { return std::min(followed, memory); }
  bool tracked() const { return camera < 0; }
  bool full() const { return followed >= window; }

 private:
  std::array<Sighting, memory> ring_;
  int newest_ = 0;
};

/// Sorts images by camera and finds the ball in them.
class Views {
 public:
  /// @param images  of this tick; none: the tracked frame stands for an image
  /// @return the view that followed the ball longest of those that were added to;
  ///         null when none has six sightings
  const View* add(const world::TrackedFrame& frame, std::span<const world::Detection> images,
                  const world::Field& field);

  /// Of a detected ball [m] per axis, learnt from balls that roll freely.
  double noise() const { return noise_; }
  void reset();

 private:
  static constexpr std::size_t most = 16;
  View* view(int camera);
  View* add(const world::TrackedFrame& frame, const world::Detection& image);
  View* add(const world::TrackedFrame& frame);
  void learn(const View& view);

  std::array<View, most> views_;
  std::size_t count_ = 0;
  double noise_ = 0.001;
};

}  // namespace touch

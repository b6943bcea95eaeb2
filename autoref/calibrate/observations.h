#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "autoref/calibrate/linker.h"
#include "sim/world/detection.h"
#include "sim/world/robot_id.h"

namespace calibrate {

/// A camera's images, whatever was in them.
struct CameraImages {
  int id = 0;
  std::vector<double> times;                      ///< [s] of capture
  std::vector<double> delays;                     ///< [s] from capture to sending
  std::int64_t frames_lost = 0;                   ///< images that its frame numbers count and nobody received
  world::Vector2d low = world::Vector2d::Zero();  ///< [m] least coordinates of ball and robots seen
  world::Vector2d high = world::Vector2d::Zero();  ///< [m] greatest

  double seconds() const { return times.empty() ? 0 : times.back() - times.front(); }
  /// How far the point is inside the part of its view that is not its edge [m]; negative outside.
  double inside(const world::Vector2d& point) const;
};

/// A place at an instant.
struct Fix {
  double time = 0;  ///< [s]
  world::Vector2d position = world::Vector2d::Zero();
};

struct Robot {
  world::RobotId id;
  std::vector<Track> tracks;
  std::vector<Fix> path;  ///< of all cameras, by time
};

/// A robot pattern with a number that is not the robot's, or with none.
struct Stray {
  std::size_t camera = 0;
  std::uint32_t image = 0;
  world::Team team{};
  bool numbered = false;
  world::Vector2d position = world::Vector2d::Zero();
};

/// A log, sorted by object.
struct Observations {
  std::vector<CameraImages> cameras;
  std::vector<Track> ball;
  std::vector<Track> false_balls;
  std::vector<Robot> robots;
  std::vector<Stray> strays;  ///< by camera, then image

  /// Where the robot was, by the sighting nearest in time; nothing when none is within 0.1 s.
  static std::optional<world::Vector2d> position_of(const Robot& robot, double time);
  /// Some robot's centre is nearer than `distance` [m] to the point at this time [s].
  bool robot_near(const world::Vector2d& point, double time, double distance) const;
};

/// Images and what was seen in them that are kept: about 60 bytes each, and as much again while they are
/// sorted. Ours: an hour and a half of four cameras with 16 robots.
inline constexpr std::size_t most_kept = 10'000'000;

/// Listens to a log and sorts it, as much of it as may be kept.
class Observer {
 public:
  explicit Observer(std::size_t most = most_kept) : most_(most) {}
  void add(const world::Detection& image);
  /// An image did not fit any more; it and all after it were left out.
  bool full() const { return full_; }
  /// What was seen; nothing is left.
  Observations finish();

 private:
  struct Eye {
    explicit Eye(std::size_t index) : balls(index, ball_gate) {}
    CameraImages images;
    std::vector<std::uint32_t> frame_numbers;
    Linker balls;
    std::map<world::RobotId, Linker> robots;
    std::vector<Stray> unread;
  };
  std::size_t most_;
  std::size_t kept_ = 0;
  bool full_ = false;
  std::map<int, std::size_t> index_;
  std::vector<Eye> eyes_;
};

}  // namespace calibrate

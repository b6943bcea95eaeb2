#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "autoref/optics/partly_hidden.h"
#include "autoref/touch/views.h"
#include "sim/world/detection.h"
#include "sim/world/field.h"
#include "sim/world/tracked_frame.h"

namespace touch {

/// The ball and the robots round it at one instant: of one image, or, when no camera saw the ball, of the
/// tracked frame.
struct TrailPoint {
  world::Time time;
  bool seen = false;                 ///< by a camera; else `ball` is where the filter believes it
  bool other_camera = false;         ///< than the one before
  Vector2d ball = Vector2d::Zero();  ///< [m]
  double sigma = 0;                  ///< [m] more of it than of a ball that is seen whole
  double airborne = 0;               ///< probability
  double height = 0;                 ///< [m] of the ball, when its flight is known
  std::array<Sighting::Robot, Sighting::most_robots> robots;
  std::size_t robot_count = 0;
  std::size_t told = robot_slots;  ///< who was then thought to be the last toucher; a slot
  double probability = 0;          ///< of that
  std::uint32_t under = 0;         ///< bits of the slots of robots that the ball flies over

  const Sighting::Robot* find(std::size_t slot) const {
    for (std::size_t n = 0; n < robot_count; ++n) {
      if (robots[n].slot == slot) return &robots[n];
    }
    return nullptr;
  }
};

/// The last seconds of the ball's way, through the camera that follows it; cameras' offsets from the tracked
/// frame are learnt from the robots and taken off.
class Trail {
 public:
  static constexpr int memory = 256;  ///< four seconds

  explicit Trail(const world::Geometry& geometry) : geometry_(geometry) {}

  /// @param told, probability  who is thought to be the last toucher now
  void add(const world::TrackedFrame& frame, std::span<const world::Detection> images, std::size_t told,
           double probability);
  void reset() { count_ = 0; }

  /// How many points are there, since the ball last jumped.
  int count() const { return std::min(count_, memory); }
  /// The camera that is nearest to a place, which is the one that shows it best [m].
  world::Vector3d camera_near(const Vector2d& place) const;
  /// 0 is the oldest.
  const TrailPoint& operator[](int n) const {
    return ring_[static_cast<std::size_t>((newest_ - count() + 1 + n + memory) % memory)];
  }

 private:
  struct Camera {
    int id = 0;
    Vector2d offset = Vector2d::Zero();  // [m] of what it sees from the tracked frame
    bool known = false;
  };
  Camera& camera(int id);
  void learn(Camera& camera, const world::Detection& image, const world::TrackedFrame& frame);
  TrailPoint& push();
  /// That the ball flies is known some images after its kick: those in between are put right.
  void lift(const world::Flight& flight);

  optics::WholeBall whole(const Vector2d& seen, const world::Detection& image) const;

  world::Geometry geometry_;
  std::array<TrailPoint, memory> ring_;
  int newest_ = -1;
  int count_ = 0;
  std::vector<Camera> cameras_;
  int followed_ = -1;  // camera of the last seen point,
  world::Time seen_;   // its time and place
  Vector2d seen_ball_ = Vector2d::Zero();
};

}  // namespace touch

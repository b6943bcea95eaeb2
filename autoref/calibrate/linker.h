#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "sim/world/geometry.h"

namespace calibrate {

/// One object in one image of one camera.
struct Sighting {
  double time = 0;                                                ///< [s] of capture
  world::Vector2d position = world::Vector2d::Zero();             ///< [m]
  double orientation = std::numeric_limits<double>::quiet_NaN();  ///< [rad]; NaN: none
  std::uint32_t image = 0;                                        ///< of this camera, counted as received
  std::uint32_t area = 0;                                         ///< [px] of a ball
};

/// What one camera saw of one object, in order of time, with gaps.
struct Track {
  std::size_t camera = 0;  ///< index into Observations::cameras
  std::vector<Sighting> sightings;

  double start() const { return sightings.front().time; }
  double end() const { return sightings.back().time; }
};

/// How far an object may be from where its motion would have brought it in a time t:
///
///   slack + min(speed t, reach) + drift t
///
/// Its motion goes on for `inertia`; once it is unseen for `patience` its track has ended.
struct Gate {
  double slack;     ///< [m]
  double speed;     ///< [m/s]
  double reach;     ///< [m]
  double drift;     ///< [m/s]
  double inertia;   ///< [s]
  double patience;  ///< [s]
};
inline constexpr Gate ball_gate{0.05, 10, 0.5, 0.5, 2, 4};  // kicks up to 10 m/s; rolls on when unseen
inline constexpr Gate robot_gate{0.05, 5, 0.5, 0.5, 0.2, 4};

/// Mean velocity [m/s] in the 0.1 s up to sighting number `i` of the track;
/// zero when nothing else was seen then.
world::Vector2d velocity_before(const Track& track, std::size_t i);

/// Makes tracks of the sightings of one kind of object in one camera, nearest first.
class Linker {
 public:
  Linker(std::size_t camera, Gate gate) : camera_(camera), gate_(gate) {}

  /// All sightings of one image.
  void add(const std::vector<Sighting>& sightings);
  /// Every track so far; nothing is left.
  std::vector<Track> finish();

 private:
  std::size_t camera_;
  Gate gate_;
  std::vector<Track> active_;
  std::vector<Track> ended_;
};

/// Which tracks are the object, of which there is one at a time: the long and far travelled ones first, each
/// one unless it was somewhere else, for a third of its images at least, while a better one saw the object.
struct Identity {
  std::vector<Track> object;
  std::vector<Track> impostors;  ///< elsewhere at the same time
  std::vector<Track> unclear;    ///< short, and hardly anybody saw the object then
};
Identity identify(std::vector<Track> tracks, std::size_t shortest);

}  // namespace calibrate

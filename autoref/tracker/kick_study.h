#pragma once

#include <boost/container/static_vector.hpp>
#include <cstddef>
#include <optional>

#include "autoref/tracker/air_filter.h"
#include "sim/world/field.h"
#include "sim/world/time.h"
#include "sim/world/tracked_frame.h"

namespace tracker {

/// What is known of a kick before its course is.
struct KickPoint {
  world::Time earliest, latest;         ///< of the kick; it may be seen before it happened
  Vector2d place = Vector2d::Zero();    ///< [m] of the ball at `earliest`
  Vector2d carried = Vector2d::Zero();  ///< [m/s] of the ball before the kick
  double sigma = 0.010;                 ///< [m] of the place
};

/// Is a kicked ball in the air? A bank of hypotheses that weigh every sighting since the kick.
///
/// For each of some instants of the kick: one AirFilter, and balls on the ground that slide for several
/// times before they roll, all with the same place of the kick as prior. Each sums up how well it foretold
/// the sightings; the sums, with an unknown noise integrated out (Student's t instead of Gauss), give the
/// probability of flight. Once it is settled the rest is dropped: on the ground the study is over, in the air
/// the best filter goes on until its hops end.
/// Source  football.md 3.3: prior of the kicker, scan of the kick's instant, flat against chip by residuals;
///         here recursive, so that one sighting costs the same however long the flight.
class KickStudy {
 public:
  /// @param geometry  decelerations and cameras
  KickStudy(const world::Geometry& geometry, const KickPoint& kick, double ball_sigma);

  /// The same for a ball that two cameras show at such places that it must be in the air at `place` [m].
  KickStudy(const world::Geometry& geometry, const Vector3d& place, world::Time time, double ball_sigma);

  /// The same for the ball of a flight that something struck since its last sighting, at `latest` or before:
  /// it is in the air still, as surely as it was.
  /// @param seen [m] where the last sighting showed it on the ground
  /// @param by  the robot that may have struck it
  KickStudy(const KickStudy& flight, world::Time latest, const Vector2d& seen,
            std::optional<world::RobotId> by);

  /// What is around the ball when it is seen.
  struct Surroundings {
    bool partly_hidden = false;  ///< a robot may hide a part of it, which moves the middle of what is seen
    std::optional<world::RobotId> under{};  ///< the robot below a ball in the air, on which it may bounce
  };
  /// Takes in a sighting.
  /// @param camera [m]
  /// @pre later than the kick and than the last one
  void see(const Vector2d& seen, world::Time time, const Vector3d& camera, const Surroundings& around);

  /// True when some hypothesis expects this sighting.
  bool explains(const Vector2d& seen, world::Time time, const Vector3d& camera,
                const Surroundings& around) const;

  int sightings() const { return sightings_; }
  double airborne() const { return airborne_; }  ///< probability of flight at the last sighting
  bool in_doubt() const;                         ///< too few sightings to say that it does not fly
  bool over() const { return over_; }            ///< on the ground, or nothing explains the sightings
  bool landed() const { return air_.front().filter.rolls(); }
  /// The flight, foretold to `time`.
  AirFilter filter_at(world::Time time) const;
  world::Flight flight_at(world::Time time) const;
  world::Time last_seen() const { return last_; }

 private:
  static constexpr std::size_t instants = 7;
  static constexpr std::size_t lengths = 6;  // of the slide

  KickStudy(const world::Geometry& geometry, double ball_sigma, world::Time time, const Vector2d& from);
  void add_ground(world::Time kicked, const Vector2d& place, double sigma, double noise, std::size_t courses);

  struct Score {
    double sum = 0;      // of normalised squares
    double log_det = 0;  // half, of all innovations
    void add(const AirFilter::Fit& fit) { sum += fit.nis, log_det += fit.log_det / 2; }
  };
  struct InAir {
    world::Time kicked;
    AirFilter filter;
    Score score;
  };
  struct Course {
    Vector2d position = Vector2d::Zero(), velocity = Vector2d::Zero();
    Score score;
  };
  struct OnGround {  // isotropic, the covariance is common to all lengths of the slide
    world::Time kicked;
    double noise = 0;  // [m^2/s^3]
    double pp = 0, pv = 0, vv = 0;
    boost::container::static_vector<Course, lengths> courses;
  };

  double evidence(const Score& score) const;
  AirFilter::Fit fit_before(const Vector2d& seen, world::Time time, double r) const;
  bool fly(AirFilter& air, double dt, const Surroundings& around) const;
  void step(OnGround& ground, double from, double to) const;
  void judge();
  bool is_possible(const InAir& air) const;
  bool is_slow() const;
  void remember_launch();

  KickPoint kick_;
  bool from_ground_ = true;  // begun by a kick
  bool struck_ = false;      // begun by something that struck a flying ball
  double air_prior_;         // probability that the ball flies before anything is seen
  double slide_, roll_;      // [m/s^2]
  double r_;                 // [m^2]
  // In place: a study begins with every kick, and none allocates.
  boost::container::static_vector<InAir, instants> air_;  // the best first
  boost::container::static_vector<OnGround, instants + 1>
      ground_;  // the last one is jostled; empty once the ball is known to fly
  int sightings_ = 0;
  int misses_ = 0;  // in a row
  double airborne_ = 0;
  bool over_ = false;
  world::Flight flight_;
  double highest_seen_ = 0;  // [m] of a ball whose kick was not
  world::Time last_;
};

}  // namespace tracker

#include "autoref/tracker/kick_study.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

namespace tracker {
namespace {

using namespace std::chrono_literals;

// How long a kicked ball slides [s]: not at all, up to 8 m/s with the dribbler's
// backspin, or anything between.
constexpr std::array slide_times = {0.0, 0.08, 0.16, 0.28, 0.45, 10.0};
constexpr double speed_sigma = 4.0;                                // [m/s] per axis, as AirFilter's
constexpr double ground_noise = 0.15 * 0.15 * world::tick_length;  // [m^2/s^3] as a rolling ball's
constexpr double jostle_noise = 12.0 * 12.0 * world::tick_length;  // as of BallFilter's erratic ball
constexpr double noise_factor = 3;  // nominal noise here over the camera's: calibration is not perfect; ours
constexpr double height_sigma = 0.03;   // [m] of a place in space between two cameras' rays; ours
constexpr double hidden_sigma = 0.005;  // [m] the visible part of a ball is up to so far beside its middle
constexpr double prior_weight = 8;      // numbers that the nominal noise counts as; ours
constexpr double chip_prior = 0.2;      // one kick in five; ours
constexpr double jostled_share = 0.25;  // of the others: two robots at the ball, a dribbler; ours
constexpr double flattest = 0.4;        // of the horizontal speed over the rise: chips up to 68 degrees; ours
constexpr double least_speed = 0.7;     // [m/s] slower is no kick worth studying; ours
constexpr double fastest = 8.5;         // [m/s] in the air: chip kickers reach 8 (football.md 5)
constexpr double least_height = 0.01;   // [m] lower a ball rolls (football.md 3.3)
constexpr int quick_look = 3;           // sightings after which slow balls are left alone
constexpr double least_rise = 1.0;  // [m/s] a kick that rises slower (5 cm) is not told from a flat one; ours
constexpr double robot_height = 0.15;  // [m] laws of 2015
constexpr double longest_fall = 0.06;  // [m] in a frame: of a ball that comes down at 3.5 m/s
constexpr double hopeless = 12;        // log of the evidence that a hypothesis may lack; ours
constexpr double gate = 40;            // chi-square with 2 degrees of freedom and three times the noise; ours
constexpr int misses_to_end = 3;
constexpr double worst_fit = 3;     // mean square: twice the nominal noise; ours
constexpr int first_word = 5;       // sightings before which nothing is said (football.md 3.3); ours
constexpr int least_sightings = 8;  // before anything is settled (football.md 3.3)
constexpr double doubtful = 0.2;    // probability; ours
constexpr double settled_flat = 0.01, settled_air = 0.98;  // probabilities
constexpr world::Duration longest_doubt = 600ms;           // ours

/// Of `count` numbers of which those that are not given are negligible.
double log_mean_exp(std::span<const double> logs, std::size_t count) {
  const double most = *std::ranges::max_element(logs);
  double sum = 0;
  for (const double value : logs) sum += std::exp(value - most);
  return most + std::log(sum / static_cast<double>(count));
}

}  // namespace

KickStudy::KickStudy(const world::Geometry& geometry, double ball_sigma, world::Time time,
                     const Vector2d& from)
    : air_prior_(chip_prior),
      slide_(std::max(0.0, geometry.ball_slide_deceleration)),
      roll_(std::max(0.0, geometry.ball_roll_deceleration)),
      r_(noise_factor * ball_sigma * noise_factor * ball_sigma),
      last_(time) {
  flight_.kicked = time;
  flight_.from = from;
}

KickStudy::KickStudy(const world::Geometry& geometry, const KickPoint& kick, double ball_sigma)
    : KickStudy(geometry, ball_sigma, kick.earliest, kick.place) {
  kick_ = kick;
  static_assert(slide_times.size() == lengths);
  constexpr int count = instants;
  for (int n = 0; n < count; ++n) {
    const auto kicked = kick.earliest + (kick.latest - kick.earliest) * (2 * n + 1) / (2 * count);
    const Vector2d place = kick.place + kick.carried * world::seconds(kicked - kick.earliest);
    air_.push_back({kicked, AirFilter(place, kick.sigma), {}});
    add_ground(kicked, place, kick.sigma, ground_noise, slide_times.size());
  }
  add_ground(kick.earliest, kick.place, kick.sigma, jostle_noise, 1);
}

KickStudy::KickStudy(const world::Geometry& geometry, const Vector3d& place, world::Time time,
                     double ball_sigma)
    : KickStudy(geometry, ball_sigma, time, place.head<2>()) {
  from_ground_ = false;
  air_.push_back({time, AirFilter(place, height_sigma), {}});
  add_ground(time, place.head<2>(), place.z(), ground_noise, 1);
  add_ground(time, place.head<2>(), place.z(), jostle_noise, 1);
}

KickStudy::KickStudy(const KickStudy& flight, world::Time latest, const Vector2d& seen,
                     std::optional<world::RobotId> by)
    : from_ground_(false),
      struck_(true),
      air_prior_(std::clamp(flight.airborne_, chip_prior, settled_air)),
      slide_(flight.slide_),
      roll_(flight.roll_),
      r_(flight.r_),
      airborne_(flight.airborne_),
      flight_(flight.flight_at(flight.last_)),
      highest_seen_(flight_.highest),
      last_(flight.last_) {
  constexpr int count = instants;
  for (int n = 0; n < count; ++n) {
    const auto struck = last_ + (latest - last_) * (2 * n + 1) / (2 * count);
    air_.push_back({struck, flight.filter_at(struck), {}});
    air_.back().filter.strike();
  }
  if (by) flight_.struck = {*by, latest};
  add_ground(last_, seen, height_sigma, ground_noise, 1);
  add_ground(last_, seen, height_sigma, jostle_noise, 1);
}

void KickStudy::add_ground(world::Time kicked, const Vector2d& place, double sigma, double noise,
                           std::size_t courses) {
  OnGround& ground = ground_.emplace_back();
  ground.kicked = kicked;
  ground.noise = noise;
  ground.pp = sigma * sigma;
  ground.vv = speed_sigma * speed_sigma;
  ground.courses.resize(courses);
  for (Course& course : ground.courses) course.position = place;
}

void KickStudy::step(OnGround& ground, double from, double to) const {
  const double dt = to - from;
  for (std::size_t n = 0; n < ground.courses.size(); ++n) {
    Course& course = ground.courses[n];
    const double sliding = std::clamp(slide_times[n] - from, 0.0, dt);
    const double rolling = dt - sliding;
    const double speed = course.velocity.norm();
    const double loss = std::min(slide_ * sliding + roll_ * rolling, speed);
    const double lag = slide_ * sliding * (sliding / 2 + rolling) + roll_ * rolling * rolling / 2;
    course.position += course.velocity * dt;
    if (!(speed > 0)) continue;
    course.position -= course.velocity * (std::min(lag, speed * dt) / speed);
    course.velocity *= (speed - loss) / speed;
  }
  ground.pp += dt * (2 * ground.pv + dt * ground.vv) + ground.noise * dt * dt * dt / 3;
  ground.pv += dt * ground.vv + ground.noise * dt * dt / 2;
  ground.vv += ground.noise * dt;
}

// Of a sighting before the kick: the ball is on its old way.
AirFilter::Fit KickStudy::fit_before(const Vector2d& seen, world::Time time, double r) const {
  const Vector2d place = kick_.place + kick_.carried * world::seconds(time - kick_.earliest);
  const double s = kick_.sigma * kick_.sigma + r;
  return {(seen - place).squaredNorm() / s, 2 * std::log(s / r)};
}

bool KickStudy::fly(AirFilter& air, double dt, const Surroundings& around) const {
  air.predict(dt);
  const double z = air.position().z();
  const bool on_it = z < robot_height && z > robot_height - longest_fall && air.velocity().z() < 0;
  if (!around.under || !on_it) return false;
  air.bounce_on(robot_height);
  return true;
}

void KickStudy::see(const Vector2d& seen, world::Time time, const Vector3d& camera,
                    const Surroundings& around) {
  const double r = around.partly_hidden ? r_ + hidden_sigma * hidden_sigma : r_;
  ++sightings_;
  const AirFilter::Fit before = fit_before(seen, time, r);
  double best_nis = std::numeric_limits<double>::infinity();
  for (InAir& air : air_) {
    AirFilter::Fit fit = before;
    if (air.kicked <= time) {
      const bool bounced = fly(air.filter, world::seconds(time - std::max(last_, air.kicked)), around);
      if (bounced && &air == &air_.front()) flight_.struck = {*around.under, time};
      fit = air.filter.update(seen, camera, r);
    }
    air.score.add(fit);
    best_nis = std::min(best_nis, fit.nis);
  }
  for (OnGround& ground : ground_) {
    if (ground.kicked > time) {
      for (Course& course : ground.courses) course.score.add(before);
      continue;
    }
    const world::Time from = std::max(last_, ground.kicked);
    step(ground, world::seconds(from - ground.kicked), world::seconds(time - ground.kicked));
    const double s = ground.pp + r;
    const double kp = ground.pp / s;
    const double kv = ground.pv / s;
    for (Course& course : ground.courses) {
      const Vector2d innovation = seen - course.position;
      course.position += kp * innovation;
      course.velocity += kv * innovation;
      const AirFilter::Fit fit{innovation.squaredNorm() / s, 2 * std::log(s / r)};
      course.score.add(fit);
      best_nis = std::min(best_nis, fit.nis);
    }
    ground.vv -= kv * ground.pv;
    ground.pv *= 1 - kp;
    ground.pp *= 1 - kp;
  }
  last_ = time;
  misses_ = best_nis > gate ? misses_ + 1 : 0;
  if (misses_ >= misses_to_end) over_ = true;
  judge();
  remember_launch();
}

double KickStudy::evidence(const Score& score) const {
  const double numbers = 2 * sightings_;
  return -(prior_weight + numbers) / 2 * std::log(1 + score.sum / prior_weight) - score.log_det;
}

void KickStudy::judge() {
  const auto better = [this](const InAir& a, const InAir& b) {
    return evidence(a.score) > evidence(b.score);
  };
  std::ranges::sort(air_, better);
  if (ground_.empty()) return;

  std::array<double, instants> in_air{};
  std::size_t airs = 0;
  for (const InAir& air : air_) in_air[airs++] = evidence(air.score);
  std::array<double, instants * slide_times.size()> rolling{};
  std::size_t rollings = 0;
  for (std::size_t n = 0; n + 1 < ground_.size(); ++n) {
    for (const Course& course : ground_[n].courses) rolling[rollings++] = evidence(course.score);
  }
  const double air_log = std::log(air_prior_) + log_mean_exp({in_air.data(), airs}, in_air.size());
  const double roll_log = std::log((1 - air_prior_) * (1 - jostled_share)) +
                          log_mean_exp({rolling.data(), rollings}, rolling.size());
  const double jostle_log =
      std::log((1 - air_prior_) * jostled_share) + evidence(ground_.back().courses.front().score);
  const double most = std::max({air_log, roll_log, jostle_log});
  const double air_share = std::exp(air_log - most);
  airborne_ = (struck_ || sightings_ >= first_word) && is_possible(air_.front())
                  ? air_share / (air_share + std::exp(roll_log - most) + std::exp(jostle_log - most))
                  : 0;

  const auto is_hopeless = [&, best = in_air[0]](const InAir& air) {
    return evidence(air.score) < best - hopeless;
  };
  air_.erase(std::remove_if(air_.begin(), air_.end(), is_hopeless), air_.end());
  if (from_ground_ && sightings_ == quick_look && is_slow()) over_ = true;
  if (sightings_ < least_sightings) return;
  if (airborne_ < settled_flat) over_ = true;
  if (airborne_ > settled_air) ground_.clear();
  if (airborne_ < 0.5 && last_ - flight_.kicked > longest_doubt) over_ = true;
}

bool KickStudy::in_doubt() const {
  return !over_ && !ground_.empty() && airborne_ <= 0.5 && (sightings_ < first_word || airborne_ > doubtful);
}

// A chip fits well, rises enough to be told from a flat kick, and not nearly straight up.
bool KickStudy::is_possible(const InAir& air) const {
  if (air.score.sum > worst_fit * 2 * sightings_) return false;
  if (air.filter.velocity().norm() > fastest) return false;
  if (!from_ground_) return air.filter.position().z() > least_height || air.filter.bounces() > 0;
  if (air.filter.bounces() > 0) return true;
  const double rise = air.filter.velocity().z() + 9.81 * world::seconds(last_ - air.kicked);
  return rise > least_rise && air.filter.velocity().head<2>().norm() > flattest * rise;
}

bool KickStudy::is_slow() const { return ground_.back().courses.front().velocity.norm() < least_speed; }

bool KickStudy::explains(const Vector2d& seen, world::Time time, const Vector3d& camera,
                         const Surroundings& around) const {
  const InAir& air = air_.front();
  AirFilter ahead = air.filter;
  fly(ahead, world::seconds(time - std::max(last_, air.kicked)), around);
  if (ahead.nis(seen, camera, r_) < gate) return true;
  return std::ranges::any_of(ground_, [&](OnGround ground) {
    if (ground.kicked > time) return fit_before(seen, time, r_).nis < gate;
    const world::Time before = std::max(last_, ground.kicked);
    step(ground, world::seconds(before - ground.kicked), world::seconds(time - ground.kicked));
    return std::ranges::any_of(ground.courses, [&](const Course& course) {
      return (seen - course.position).squaredNorm() < gate * (ground.pp + r_);
    });
  });
}

void KickStudy::remember_launch() {
  const InAir& air = air_.front();
  if (!from_ground_) {  // its kick was not seen: what is known begins here
    if (sightings_ == 1 && !struck_) flight_.launch_velocity = air.filter.velocity();
    highest_seen_ = std::max(highest_seen_, air.filter.position().z());
    return;
  }
  if (air.filter.bounces() > 0) return;
  const double since = world::seconds(last_ - air.kicked);
  const Vector3d velocity = air.filter.velocity();
  flight_.kicked = air.kicked;
  flight_.launch_velocity = velocity + Vector3d(0, 0, 9.81 * since);
  flight_.from = (air.filter.position() - velocity * since).head<2>();
}

AirFilter KickStudy::filter_at(world::Time time) const {
  AirFilter ahead = air_.front().filter;
  ahead.predict(std::max(0.0, world::seconds(time - std::max(last_, air_.front().kicked))));
  return ahead;
}

world::Flight KickStudy::flight_at(world::Time time) const {
  // On its way up it is as high as it is; later it was as high as its rise at the kick took it.
  world::Flight flight = flight_;
  if (!from_ground_) {
    flight.highest = highest_seen_;
    return flight;
  }
  const double rise = std::max(0.0, flight.launch_velocity.z());
  const double up = std::min(rise / 9.81, std::max(0.0, world::seconds(time - flight.kicked)));
  flight.highest = up * (rise - 9.81 / 2 * up);
  return flight;
}

}  // namespace tracker

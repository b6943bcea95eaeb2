#include "autoref/calibrate/robots.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <optional>
#include <span>

namespace calibrate {
namespace {

using world::Vector2d;

constexpr double window = 0.2;       // [s] of a parabola through positions
constexpr double turn_window = 0.1;  // [s] and through orientations: 50 rad/s^2 are over in 0.2 s
constexpr double moving = 0.3;       // [m/s] slower has no clear sign
constexpr double turning = 1;        // [rad/s]
constexpr std::size_t enough = 300;  // windows in motion
constexpr double in_a_row = 10;      // windows that share most of their sightings
constexpr double quantile_of_speed = 0.999;
constexpr double quantile_of_acceleration = 0.99;

struct Motion {
  double speed = 0;
  double acceleration = 0;
  double speed_noise = 0;  ///< for a noise of 1 per value
  double acceleration_noise = 0;
};

// Parabola through values at times around the middle one; nothing when it leaves more than `most` (rms).
std::optional<Motion> parabola(std::span<const double> times, std::span<const double> values, double middle,
                               double most) {
  const auto n = static_cast<Eigen::Index>(times.size());
  Eigen::MatrixX3d columns(n, 3);
  Eigen::VectorXd wanted(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double t = times[static_cast<std::size_t>(i)] - middle;
    columns.row(i) << 1, t, t * t / 2;
    wanted[i] = values[static_cast<std::size_t>(i)];
  }
  const Eigen::Matrix3d inverse = (columns.transpose() * columns).inverse();
  const Eigen::Vector3d x = inverse * (columns.transpose() * wanted);
  const double rms = std::sqrt((columns * x - wanted).squaredNorm() / static_cast<double>(n - 3));
  if (!(rms <= most)) return std::nullopt;
  return Motion{x[1], x[2], std::sqrt(inverse(1, 1)), std::sqrt(inverse(2, 2))};
}

// What was seen of one axis: forward, sideways or turning.
struct Axis {
  std::vector<double> speeds, speeding_up, braking;
  double speed_noise = 0;  // sums of the parabolas'
  double acceleration_noise = 0;

  void add(const Motion& motion, double slowest) {
    if (std::abs(motion.speed) < slowest) return;
    speed_noise += motion.speed_noise;
    acceleration_noise += motion.acceleration_noise;
    speeds.push_back(std::abs(motion.speed));
    (motion.speed * motion.acceleration > 0 ? speeding_up : braking).push_back(std::abs(motion.acceleration));
  }
};

// Sightings of which none is missing, of the given length around number i; empty when there is none.
std::span<const Sighting> around(std::span<const Sighting> all, std::size_t i, double length) {
  std::size_t begin = i;
  std::size_t end = i + 1;
  while (begin > 0 && all[i].time - all[begin - 1].time <= length / 2 + 1e-3) --begin;
  while (end < all.size() && all[end].time - all[i].time <= length / 2 + 1e-3) ++end;
  const bool whole = all[end - 1].image - all[begin].image == end - begin - 1 && end - begin >= 5 &&
                     all[end - 1].time - all[begin].time > 0.75 * length;
  return whole ? all.subspan(begin, end - begin) : std::span<const Sighting>{};
}

void watch(const Track& track, const Noise& noise, Axis& forward, Axis& sideways, Axis& turn) {
  std::vector<double> times;
  std::array<std::vector<double>, 2> places;
  std::vector<double> angles;
  for (std::size_t i = 0; i < track.sightings.size(); ++i) {
    const Sighting& middle = track.sightings[i];
    if (!std::isfinite(middle.orientation)) continue;
    times.clear();
    for (auto& axis : places) axis.clear();
    for (const Sighting& s : around(track.sightings, i, window)) {
      times.push_back(s.time);
      places[0].push_back(s.position.x());
      places[1].push_back(s.position.y());
    }
    if (!times.empty()) {
      const auto x = parabola(times, places[0], middle.time, 3 * noise.robot);
      const auto y = parabola(times, places[1], middle.time, 3 * noise.robot);
      if (x && y) {
        const Vector2d speed = world::rotated({x->speed, y->speed}, -middle.orientation);
        const Vector2d acceleration = world::rotated({x->acceleration, y->acceleration}, -middle.orientation);
        forward.add({speed.x(), acceleration.x(), x->speed_noise, x->acceleration_noise}, moving);
        sideways.add({speed.y(), acceleration.y(), y->speed_noise, y->acceleration_noise}, moving);
      }
    }
    times.clear();
    angles.clear();
    for (const Sighting& s : around(track.sightings, i, turn_window)) {
      times.push_back(s.time);
      angles.push_back(world::wrap_angle(s.orientation - middle.orientation));
    }
    if (times.empty()) continue;
    if (const auto motion = parabola(times, angles, middle.time, 3 * noise.orientation)) {
      turn.add(*motion, turning);
    }
  }
}

// A high quantile of noisy values lies 0 to 2 of their errors above that of the true ones, the more, the
// longer robots were at their limit: one is taken off, and counted as error.
void report_one(std::string_view key, const std::string& name, const std::string& unit,
                std::vector<double>& values, double p, double noise, Report& report) {
  if (values.size() < enough) {
    report.lack(
        key, name,
        fmt::format("too few: {} stretches of such motion; at least {} are needed", values.size(), enough));
    return;
  }
  Estimate found = high_quantile(values, p, in_a_row);
  found.value -= noise;
  found.error = std::hypot(found.error, noise);
  report.add(key, name, unit, found,
             fmt::format("{:.4g} % quantile while moving, less noise of {:.2g}", 100 * p, noise));
}

void report_axis(const std::string& of_speed, const std::string& of_acceleration, const std::string& of_brake,
                 const std::string& name, const std::string& unit, Axis& axis, double noise, Report& report) {
  noise /= std::max(static_cast<double>(axis.speeds.size()), 1.0);
  report_one("robots." + of_speed, "robot speed, " + name, unit, axis.speeds, quantile_of_speed,
             noise * axis.speed_noise, report);
  report_one("robots." + of_acceleration, "robot acceleration, " + name, unit + "^2", axis.speeding_up,
             quantile_of_acceleration, noise * axis.acceleration_noise, report);
  report_one("robots." + of_brake, "robot braking, " + name, unit + "^2", axis.braking,
             quantile_of_acceleration, noise * axis.acceleration_noise, report);
}

}  // namespace

void add_robots(const Observations& seen, const Noise& noise, Report& report) {
  Axis forward;
  Axis sideways;
  Axis turn;
  for (const Robot& robot : seen.robots) {
    for (const Track& track : robot.tracks) watch(track, noise, forward, sideways, turn);
  }
  report_axis("max_speed", "max_acceleration", "max_brake", "forward", "m/s", forward, noise.robot, report);
  report_axis("max_speed_sideways", "max_acceleration_sideways", "max_brake_sideways", "sideways", "m/s",
              sideways, noise.robot, report);
  report_axis("max_angular_speed", "max_angular_acceleration", "max_angular_brake", "turning", "rad/s", turn,
              noise.orientation, report);
}

}  // namespace calibrate

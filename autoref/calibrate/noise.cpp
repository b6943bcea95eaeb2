#include "autoref/calibrate/noise.h"

#include <fmt/format.h>

#include <cmath>

namespace calibrate {
namespace {

constexpr double longest_span = 0.12;  // [s] of four sightings
constexpr double contact = 0.2;        // [m] a ball nearer to a robot's centre may be touched
constexpr double still = 0.05;         // [m/s] slower counts as resting
constexpr std::size_t enough = 100;

// One difference in three stands for an independent one: neighbours share three of four sightings
// (autocorrelations -3/4, 3/10, -1/20 make 1 + 2 sum rho^2 = 2.3), and x and y are counted apart.
constexpr double repetition = 2.3;

// What motion of robots adds even to a median (README).
constexpr double motion_left = 0.02;

enum class Kind { Resting, Across, Along, Turning };

struct Row {
  Kind kind;
  const char* name;
};
constexpr std::array<Row, 4> rows = {{{Kind::Resting, "  resting"},
                                      {Kind::Across, "  moving, across the way"},
                                      {Kind::Along, "  moving, along it (not counted)"},
                                      {Kind::Turning, "  turning"}}};

struct Sample {
  std::size_t camera;
  Kind kind;
  double value;
};

std::vector<double> select(const std::vector<Sample>& samples, auto&& wanted) {
  std::vector<double> values;
  for (const Sample& sample : samples) {
    if (wanted(sample)) values.push_back(sample.value);
  }
  return values;
}

void add_positions(const Track& track, const Observations& seen, bool is_ball, std::vector<Sample>& out) {
  const auto& all = track.sightings;
  for (std::size_t i = 0; i + 3 < all.size(); ++i) {
    const double span = all[i + 3].time - all[i].time;
    if (span > longest_span) continue;
    if (is_ball && seen.robot_near(all[i + 1].position, all[i + 1].time, contact)) continue;
    const std::array<double, 4> times = {all[i].time, all[i + 1].time, all[i + 2].time, all[i + 3].time};
    const world::Vector2d way = all[i + 3].position - all[i].position;
    const bool moving = way.norm() > still * span + 0.002;
    world::Vector2d difference;
    for (const int axis : {0, 1}) {
      difference[axis] = third_difference(times, {all[i].position[axis], all[i + 1].position[axis],
                                                  all[i + 2].position[axis], all[i + 3].position[axis]});
    }
    if (moving) difference = world::rotated(difference, -world::angle_of(way));
    out.push_back({track.camera, moving ? Kind::Along : Kind::Resting, difference.x()});
    out.push_back({track.camera, moving ? Kind::Across : Kind::Resting, difference.y()});
  }
}

void add_orientations(const Track& track, std::vector<Sample>& out) {
  const auto& all = track.sightings;
  for (std::size_t i = 0; i + 3 < all.size(); ++i) {
    if (all[i + 3].time - all[i].time > longest_span) continue;
    std::array<double, 4> times{};
    std::array<double, 4> angles{};
    for (std::size_t k = 0; k < 4; ++k) {
      times[k] = all[i + k].time;
      angles[k] = k == 0 ? all[i].orientation
                         : angles[k - 1] + world::wrap_angle(all[i + k].orientation - angles[k - 1]);
    }
    const double value = third_difference(times, angles);
    const bool turning = std::abs(angles[3] - angles[0]) > 0.02;
    if (std::isfinite(value)) out.push_back({track.camera, turning ? Kind::Turning : Kind::Resting, value});
  }
}

double report_one(const std::vector<Sample>& samples, const Observations& seen, std::string_view key,
                  const std::string& name, const std::string& unit, double otherwise, Report& report) {
  const auto estimate = [](std::vector<double> values) {
    Estimate e = spread(values, repetition);
    e.error = std::hypot(e.error, motion_left * e.value);
    return e;
  };
  // Along the way errors of the time of capture add to the noise: up to four times as much in a real log.
  const auto counts = [](const Sample& s) { return s.kind != Kind::Along; };
  std::vector<double> counted = select(samples, counts);
  if (counted.size() < enough) {
    report.lack(key, name,
                fmt::format("too few: {} differences; at least {} are needed", counted.size(), enough));
    return otherwise;
  }
  const Estimate all = estimate(std::move(counted));
  report.add(key, name, unit, all, "robust spread of third differences");
  double in_motion = all.value;
  for (const Row& row : rows) {
    std::vector<double> part = select(samples, [&](const Sample& s) { return s.kind == row.kind; });
    if (part.size() < enough) continue;
    const Estimate found = estimate(std::move(part));
    report.tell(row.name, unit, found, "the same");
    if (row.kind == Kind::Along) in_motion = std::max(in_motion, found.value);
  }
  for (std::size_t camera = 0; camera < seen.cameras.size() && seen.cameras.size() > 1; ++camera) {
    std::vector<double> part =
        select(samples, [&](const Sample& s) { return counts(s) && s.camera == camera; });
    if (part.size() < enough) continue;
    report.tell(fmt::format("  camera {}", seen.cameras[camera].id), unit, estimate(std::move(part)),
                "the same");
  }
  return in_motion;
}

}  // namespace

double third_difference(const std::array<double, 4>& times, const std::array<double, 4>& values) {
  double sum = 0;
  double squares = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    double weight = 1;
    for (std::size_t j = 0; j < 4; ++j) {
      if (j != i) weight /= times[i] - times[j];
    }
    sum += weight * values[i];
    squares += weight * weight;
  }
  return sum / std::sqrt(squares);
}

Noise add_noise(const Observations& seen, Report& report) {
  std::vector<Sample> ball;
  std::vector<Sample> robots;
  std::vector<Sample> orientations;
  for (const Track& track : seen.ball) add_positions(track, seen, true, ball);
  for (const Robot& robot : seen.robots) {
    for (const Track& track : robot.tracks) {
      add_positions(track, seen, false, robots);
      add_orientations(track, orientations);
    }
  }
  Noise noise;
  noise.ball = report_one(ball, seen, "vision.ball_sigma", "ball noise, per axis", "m", noise.ball, report);
  noise.robot =
      report_one(robots, seen, "vision.robot_sigma", "robot noise, per axis", "m", noise.robot, report);
  noise.orientation = report_one(orientations, seen, "vision.orientation_sigma", "orientation noise", "rad",
                                 noise.orientation, report);
  return noise;
}

}  // namespace calibrate

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

// What motion of robots adds even to a median: 3 % in driven games of the simulator (README).
constexpr double motion_left = 0.02;

struct Sample {
  std::size_t camera;
  bool moving;
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
    const bool moving = (all[i + 3].position - all[i].position).norm() > still * span + 0.002;
    for (const int axis : {0, 1}) {
      const double value = third_difference(times, {all[i].position[axis], all[i + 1].position[axis],
                                                    all[i + 2].position[axis], all[i + 3].position[axis]});
      out.push_back({track.camera, moving, value});
    }
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
    if (std::isfinite(value)) out.push_back({track.camera, std::abs(angles[3] - angles[0]) > 0.02, value});
  }
}

double report_one(const std::vector<Sample>& samples, const Observations& seen, std::string_view key,
                  const std::string& name, const std::string& unit, double otherwise, Report& report) {
  if (samples.size() < enough) {
    report.lack(key, name,
                fmt::format("too few: {} differences; at least {} are needed", samples.size(), enough));
    return otherwise;
  }
  const auto estimate = [](std::vector<double> values) {
    Estimate e = spread(values, repetition);
    e.error = std::hypot(e.error, motion_left * e.value);
    return e;
  };
  const Estimate all = estimate(select(samples, [](const Sample&) { return true; }));
  report.add(key, name, unit, all, "robust spread of third differences");
  for (const bool moving : {false, true}) {
    std::vector<double> part = select(samples, [&](const Sample& s) { return s.moving == moving; });
    if (part.size() < enough) continue;
    report.tell(fmt::format("  {}", moving ? "moving" : "resting"), unit, estimate(std::move(part)),
                "the same");
  }
  for (std::size_t camera = 0; camera < seen.cameras.size() && seen.cameras.size() > 1; ++camera) {
    std::vector<double> part = select(samples, [&](const Sample& s) { return s.camera == camera; });
    if (part.size() < enough) continue;
    report.tell(fmt::format("  camera {}", seen.cameras[camera].id), unit, estimate(std::move(part)),
                "the same");
  }
  return all.value;
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

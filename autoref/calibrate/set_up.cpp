#include "autoref/calibrate/set_up.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/world/time.h"

namespace calibrate {
namespace {

using world::Vector3d;

constexpr double apart = 1.0;  // [m] least distance of cameras in different columns or rows

void add_rates(const Observations& seen, Report& report) {
  std::vector<double> delays;
  for (const CameraImages& camera : seen.cameras) {
    std::ranges::copy(camera.delays, std::back_inserter(delays));
    if (camera.times.size() < 2) continue;
    std::vector<double> steps;
    for (std::size_t i = 1; i < camera.times.size(); ++i)
      steps.push_back(camera.times[i] - camera.times[i - 1]);
    const Estimate step = high_quantile(steps, 0.5, 1);
    report.tell(fmt::format("camera {}: images", camera.id), "1/s",
                {1 / step.value, step.error / (step.value * step.value), camera.times.size()},
                "median of the steps between captures");
  }
  if (delays.empty()) return;
  const Estimate delay = high_quantile(delays, 0.5, 1);
  report.tell("delay from capture to sending", "s", delay,
              fmt::format("median; 99 % quantile {:.4f} s; the network adds to it", quantile(delays, 0.99)));
  report.add("vision.delay", "delay in ticks of 1/60 s", "ticks",
             {delay.value / world::tick_length, delay.error / world::tick_length, delay.samples},
             fmt::format("{:.2f} ticks, rounded", delay.value / world::tick_length));
}

const CameraImages* images_of(const Observations& seen, int id) {
  const auto found = std::ranges::find(seen.cameras, id, &CameraImages::id);
  return found == seen.cameras.end() || found->low == found->high ? nullptr : &*found;
}

// Camera b is the next one from a along the axis, in the same row or column.
bool next_along(const std::vector<world::Camera>& cameras, const world::Camera& a, const world::Camera& b,
                int axis) {
  const auto beside = [&](const world::Camera& other) {
    const Vector3d to = other.position - a.position;
    return to[axis] > apart && std::abs(to[1 - axis]) < to[axis] / 2;
  };
  return beside(b) && std::ranges::none_of(cameras, [&](const world::Camera& c) {
           return beside(c) && c.position[axis] < b.position[axis] - apart;
         });
}

// Half of the strip that both of two neighbours saw: how far each sees beyond the line in the strip's middle.
std::vector<double> reaches(const Observations& seen, const std::vector<world::Camera>& cameras) {
  std::vector<double> beyond;
  for (const world::Camera& a : cameras) {
    for (const world::Camera& b : cameras) {
      const CameraImages* left = images_of(seen, a.id);
      const CameraImages* right = images_of(seen, b.id);
      if (left == nullptr || right == nullptr) continue;
      for (const int axis : {0, 1}) {
        if (next_along(cameras, a, b, axis)) beyond.push_back((left->high[axis] - right->low[axis]) / 2);
      }
    }
  }
  return beyond;
}

}  // namespace

void add_set_up(const Observations& seen, const std::optional<world::Geometry>& geometry, Report& report) {
  const std::size_t n = seen.cameras.size();
  if (n == 1 || n == 2 || n == 4 || n == 6 || n == 8) {
    report.add("vision.cameras", "cameras", "", {static_cast<double>(n), 0, n}, "that sent images");
  } else {
    report.lack("vision.cameras", "cameras",
                fmt::format("{} sent images; the simulator has 1, 2, 4, 6 or 8", n));
  }
  std::vector<world::Camera> cameras;
  if (geometry) {
    std::ranges::copy_if(geometry->cameras, std::back_inserter(cameras), [&](const world::Camera& camera) {
      return std::ranges::find(seen.cameras, camera.id, &CameraImages::id) != seen.cameras.end();
    });
  }
  if (cameras.empty()) {
    const std::string why =
        geometry ? "the log's geometry places none of the cameras" : "no geometry in the log";
    report.lack("vision.camera_height", "camera height", why);
    report.lack("vision.overlap", "overlap", why);
  } else {
    double sum = 0;
    double low = cameras.front().position.z();
    double high = low;
    for (const world::Camera& camera : cameras) {
      sum += camera.position.z();
      low = std::min(low, camera.position.z());
      high = std::max(high, camera.position.z());
    }
    report.add("vision.camera_height", "camera height", "m",
               {sum / static_cast<double>(cameras.size()), (high - low) / 2, cameras.size()},
               fmt::format("mean of the geometry's, {:.2f} to {:.2f}", low, high));
    std::vector<double> beyond = reaches(seen, cameras);
    if (beyond.empty()) {
      report.lack("vision.overlap", "overlap", "no two cameras stand beside each other");
    } else {
      const auto [least, most] = std::ranges::minmax(beyond);
      report.add("vision.overlap", "overlap", "m", {std::max(0.0, most), (most - least) / 2, beyond.size()},
                 fmt::format("half of the widest strip that two neighbours both saw; {:.2f} to {:.2f}", least,
                             most));
    }
  }
  add_rates(seen, report);
  for (const world::Team team : world::both_teams) {
    const auto robots = std::ranges::count_if(seen.robots, [&](const Robot& r) { return r.id.team == team; });
    report.tell(fmt::format("{} robots", name(team)), "",
                {static_cast<double>(robots), 0, static_cast<std::size_t>(robots)},
                "numbers seen for 50 images in a row, mostly");
  }
}

}  // namespace calibrate

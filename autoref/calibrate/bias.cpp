#include "autoref/calibrate/bias.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace calibrate {
namespace {

using world::Vector2d;

constexpr double longest_step = 0.05;  // [s] between two sightings for one in between to be interpolated
constexpr std::size_t enough = 30;     // differences of a pair

struct Pair {
  std::size_t first, second;
  std::array<std::vector<double>, 2> differences;  // [m] per axis
};

// What `a` saw minus what `b` saw at the same instants.
void compare(const Track& a, const Track& b, Pair& pair) {
  for (const Sighting& s : a.sightings) {
    const auto after = std::ranges::lower_bound(b.sightings, s.time, {}, &Sighting::time);
    if (after == b.sightings.begin() || after == b.sightings.end()) continue;
    const Sighting& before = *(after - 1);
    const double step = after->time - before.time;
    if (step > longest_step) continue;
    const Vector2d between =
        before.position + (after->position - before.position) * ((s.time - before.time) / step);
    for (const int axis : {0, 1})
      pair.differences[static_cast<std::size_t>(axis)].push_back(s.position[axis] - between[axis]);
  }
}

void compare_all(const std::vector<Track>& tracks, std::vector<Pair>& pairs) {
  for (Pair& pair : pairs) {
    for (const Track& a : tracks) {
      if (a.camera != pair.first) continue;
      for (const Track& b : tracks) {
        if (b.camera == pair.second && b.end() > a.start() && b.start() < a.end()) compare(a, b, pair);
      }
    }
  }
}

// The number of groups of cameras that no pair joins.
int count_groups(std::size_t cameras, const std::vector<Pair>& pairs) {
  std::vector<std::size_t> group(cameras);
  std::iota(group.begin(), group.end(), 0U);
  for (const Pair& pair : pairs) {
    const std::size_t from = group[pair.second];
    const std::size_t to = group[pair.first];
    std::ranges::replace(group, from, to);
  }
  std::ranges::sort(group);
  return static_cast<int>(std::distance(group.begin(), std::unique(group.begin(), group.end())));
}

}  // namespace

void add_bias(const Observations& seen, Report& report) {
  constexpr std::string_view key = "vision.bias_sigma";
  const std::string name = "camera bias, per axis";
  const std::size_t n = seen.cameras.size();
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) pairs.push_back({i, j, {}});
  }
  compare_all(seen.ball, pairs);
  for (const Robot& robot : seen.robots) compare_all(robot.tracks, pairs);
  std::erase_if(pairs, [](const Pair& pair) { return pair.differences[0].size() < enough; });
  if (pairs.empty()) {
    report.lack(key, name,
                fmt::format("no two cameras saw one thing at the same time in {} images or more", enough));
    return;
  }

  // The null space (one common offset per group) is resolved by the least norm: each group's mean is zero.
  Eigen::MatrixXd incidence =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(pairs.size()), static_cast<Eigen::Index>(n));
  Eigen::MatrixXd offsets(static_cast<Eigen::Index>(pairs.size()), 2);
  std::size_t samples = 0;
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    const auto row = static_cast<Eigen::Index>(p);
    incidence(row, static_cast<Eigen::Index>(pairs[p].first)) = 1;
    incidence(row, static_cast<Eigen::Index>(pairs[p].second)) = -1;
    samples += pairs[p].differences[0].size();
    for (const int axis : {0, 1}) {
      std::vector<double>& values = pairs[p].differences[static_cast<std::size_t>(axis)];
      offsets(row, axis) = median(values);
    }
    std::array<double, 2> scatter{};
    for (const std::size_t axis : {0U, 1U}) {
      for (double& value : pairs[p].differences[axis]) value -= offsets(row, static_cast<Eigen::Index>(axis));
      scatter[axis] = spread(pairs[p].differences[axis]).value;
    }
    report.tell(
        fmt::format("  cameras {} and {}: distance", seen.cameras[pairs[p].first].id,
                    seen.cameras[pairs[p].second].id),
        "m",
        {offsets.row(row).norm(),
         std::hypot(scatter[0], scatter[1]) / std::sqrt(static_cast<double>(pairs[p].differences[0].size())),
         pairs[p].differences[0].size()},
        fmt::format("median difference ({:+.4f}, {:+.4f}), spread {:.4f} and {:.4f}", offsets(row, 0),
                    offsets(row, 1), scatter[0], scatter[1]));
  }
  const Eigen::MatrixXd bias = incidence.completeOrthogonalDecomposition().solve(offsets);
  const int freedom = 2 * (static_cast<int>(n) - count_groups(n, pairs));
  const double sigma = std::sqrt(bias.squaredNorm() / freedom);
  report.add(key, name, "m", {sigma, sigma / std::sqrt(2.0 * freedom), samples},
             fmt::format("offsets of {} pairs of cameras, {} degrees of freedom; mean offset counts as zero",
                         pairs.size(), freedom));
}

}  // namespace calibrate

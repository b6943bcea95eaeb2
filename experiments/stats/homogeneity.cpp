#include "experiments/stats/homogeneity.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "experiments/stats/distributions.h"

namespace stats {
namespace {

struct Sums {
  std::vector<double> rows;
  std::vector<double> columns;
  double all = 0;
};

Sums sums_of(std::span<const GroupCounts> groups) {
  Sums sums;
  if (!groups.empty()) sums.columns.assign(groups.front().counts.size(), 0);
  for (const GroupCounts& group : groups) {
    assert(group.counts.size() == sums.columns.size());
    sums.rows.push_back(0);
    for (std::size_t j = 0; j < group.counts.size(); ++j) {
      const double count = static_cast<double>(group.counts[j]);
      sums.rows.back() += count;
      sums.columns[j] += count;
      sums.all += count;
    }
  }
  return sums;
}

}  // namespace

Homogeneity homogeneity(std::span<const GroupCounts> groups, double least) {
  Homogeneity result;
  std::vector<GroupCounts> used(groups.begin(), groups.end());
  Sums sums;
  while (true) {
    sums = sums_of(used);
    if (used.empty() || sums.all == 0) return result;
    // The smallest row has the smallest expectations; the rarest column decides.
    double rarest = std::numeric_limits<double>::infinity();
    for (const double column : sums.columns) {
      if (column > 0) rarest = std::min(rarest, column);
    }
    const auto smallest = std::min_element(sums.rows.begin(), sums.rows.end());
    if (*smallest * rarest / sums.all > least) break;
    const auto index = smallest - sums.rows.begin();
    result.dropped.push_back(used[static_cast<std::size_t>(index)].name);
    used.erase(used.begin() + index);
  }
  std::int64_t columns = 0;
  for (const double column : sums.columns) columns += column > 0 ? 1 : 0;
  result.freedom = (static_cast<std::int64_t>(used.size()) - 1) * (columns - 1);
  if (result.freedom <= 0) {
    result.freedom = 0;
    return result;
  }
  for (std::size_t i = 0; i < used.size(); ++i) {
    double row = 0;
    for (std::size_t j = 0; j < sums.columns.size(); ++j) {
      if (sums.columns[j] == 0) continue;
      const double expected = sums.rows[i] * sums.columns[j] / sums.all;
      const double off = static_cast<double>(used[i].counts[j]) - expected;
      row += off * off / expected;
    }
    result.chi_square += row;
    const double adjusted = row / (1 - sums.rows[i] / sums.all);
    result.rows.push_back(
        {used[i].name, adjusted, 1 - chi_square_cdf(adjusted, static_cast<double>(columns - 1))});
  }
  result.p = 1 - chi_square_cdf(result.chi_square, static_cast<double>(result.freedom));
  return result;
}

RunsTest runs_test(std::span<const double> values) {
  RunsTest result;
  if (values.empty()) return result;
  std::vector<double> sorted(values.begin(), values.end());
  std::sort(sorted.begin(), sorted.end());
  const std::size_t middle = sorted.size() / 2;
  const double median = sorted.size() % 2 == 1 ? sorted[middle] : (sorted[middle - 1] + sorted[middle]) / 2;
  int last = 0;
  for (const double value : values) {
    if (value == median) continue;
    const int side = value > median ? 1 : -1;
    ++(side > 0 ? result.above : result.below);
    if (side != last) ++result.runs;
    last = side;
  }
  const double m = static_cast<double>(result.above);
  const double k = static_cast<double>(result.below);
  const double n = m + k;
  if (n < 10 || m == 0 || k == 0) return result;
  result.expected = 1 + 2 * m * k / n;
  const double deviation = std::sqrt(2 * m * k * (2 * m * k - n) / (n * n * (n - 1)));
  const double off = static_cast<double>(result.runs) - result.expected;
  result.z = off / deviation;
  result.p = std::min(1.0, 2 * normal_cdf(-std::max(0.0, std::abs(off) - 0.5) / deviation));
  return result;
}

}  // namespace stats

#include "autoref/calibrate/ball_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace calibrate {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index end_images = 4;  // of each phase at least

double positive_part(double x) { return std::max(x, 0.0); }

struct Line {
  VectorXd times, along;
  double across = 0;  // [m] rms
};

// The straight line through all sightings: times from the first one, places along the line.
Line straightened(std::span<const Sighting> sightings) {
  const auto n = static_cast<Index>(sightings.size());
  Eigen::MatrixX2d places(n, 2);
  Line line{VectorXd(n), VectorXd(n)};
  for (Index i = 0; i < n; ++i) {
    const Sighting& s = sightings[static_cast<std::size_t>(i)];
    places.row(i) = s.position.transpose();
    line.times[i] = s.time - sightings.front().time;
  }
  const Eigen::RowVector2d middle = places.colwise().mean();
  places.rowwise() -= middle;
  const Eigen::Matrix2d moments = places.transpose() * places;
  const double angle = 0.5 * std::atan2(2 * moments(0, 1), moments(0, 0) - moments(1, 1));
  Eigen::Vector2d way = world::direction(angle);
  if ((sightings.back().position - sightings.front().position).dot(way) < 0) way = -way;
  line.along = places * way;
  line.across = (places * Eigen::Vector2d(-way.y(), way.x())).norm() / std::sqrt(static_cast<double>(n));
  return line;
}

// Columns x, v and deceleration; with a knot the decelerations before and after it.
MatrixXd design(const VectorXd& t, std::optional<double> knot) {
  MatrixXd columns(t.size(), knot ? 4 : 3);
  for (Index i = 0; i < t.size(); ++i) {
    columns(i, 0) = 1;
    columns(i, 1) = t[i];
    columns(i, 2) = -t[i] * t[i] / 2;
    if (!knot) continue;
    columns(i, 3) = -std::pow(positive_part(t[i] - *knot), 2) / 2;
    columns(i, 2) -= columns(i, 3);
  }
  return columns;
}

struct Solution {
  VectorXd x;
  double squares = 0;
};

Solution solve(const Line& line, std::optional<double> knot) {
  const MatrixXd columns = design(line.times, knot);
  Solution solution;
  solution.x = columns.colPivHouseholderQr().solve(line.along);
  solution.squares = (columns * solution.x - line.along).squaredNorm();
  return solution;
}

// The instant that leaves the least squares: a grid, then thirds.
double best_knot(const Line& line) {
  const Index n = line.times.size();
  double best = line.times[end_images];
  double least = solve(line, best).squares;
  for (Index i = end_images; i < n - end_images; ++i) {
    const double squares = solve(line, line.times[i]).squares;
    if (squares < least) {
      least = squares;
      best = line.times[i];
    }
  }
  const double step = line.times[n - 1] / static_cast<double>(n - 1);
  double low = best - step;
  double high = best + step;
  for (int round = 0; round < 20; ++round) {
    const double a = low + (high - low) / 3;
    const double b = high - (high - low) / 3;
    const bool left = solve(line, a).squares < solve(line, b).squares;
    (left ? high : low) = left ? b : a;
  }
  return (low + high) / 2;
}

VectorXd errors(const MatrixXd& jacobian, double variance) {
  const Index n = jacobian.cols();
  const MatrixXd covariance =
      (jacobian.transpose() * jacobian).ldlt().solve(MatrixXd::Identity(n, n)) * variance;
  return covariance.diagonal().cwiseMax(0).cwiseSqrt();
}

}  // namespace

BallFit fit_ball(std::span<const Sighting> sightings) {
  const Line line = straightened(sightings);
  const auto n = static_cast<double>(sightings.size());
  BallFit fit;
  fit.across = line.across;

  const Solution one = solve(line, std::nullopt);
  if (sightings.size() >= 14) {
    const double knot = best_knot(line);
    const Solution two = solve(line, knot);
    const double variance = two.squares / (n - 5);
    const double change = two.x[2] - two.x[3];
    if ((one.squares - two.squares) / 2 > 15 * variance && change > 0.5) {
      MatrixXd jacobian(line.times.size(), 5);  // the knot, too, is a number that was fitted
      jacobian.leftCols(4) = design(line.times, knot);
      for (Index i = 0; i < line.times.size(); ++i) {
        jacobian(i, 4) = change * positive_part(line.times[i] - knot);
      }
      const VectorXd error = errors(jacobian, variance);
      fit.speed = {two.x[1], error[1], sightings.size()};
      fit.first = {two.x[2], error[2], sightings.size()};
      fit.second = Estimate{two.x[3], error[3], sightings.size()};
      fit.switch_speed = two.x[1] - two.x[2] * knot;
      fit.along = std::sqrt(two.squares / n);
      return fit;
    }
  }
  const VectorXd error = errors(design(line.times, std::nullopt), one.squares / (n - 3));
  fit.speed = {one.x[1], error[1], sightings.size()};
  fit.first = {one.x[2], error[2], sightings.size()};
  fit.along = std::sqrt(one.squares / n);
  return fit;
}

}  // namespace calibrate

#include "autoref/touch/likelihood.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/world/time.h"

namespace touch {
namespace {

double gauss(double x, double sigma) {
  return std::exp(-x * x / (2 * sigma * sigma)) / (sigma * std::sqrt(2 * std::numbers::pi));
}
double gauss2(double r2, double sigma) {
  return std::exp(-r2 / (2 * sigma * sigma)) / (2 * std::numbers::pi * sigma * sigma);
}

/// A straight piece through three sightings, newest first: least squares.
struct Piece {
  double time = 0;                       // [s] of the middle
  Vector2d middle = Vector2d::Zero();    // [m]
  Vector2d velocity = Vector2d::Zero();  // [m/s]
  double spread = 0;                     // [s^2]
  double residual = 0;                   // [m^2]
  Vector2d at(double t) const { return middle + velocity * (t - time); }
};

Piece piece(const View& view, int first) {
  const world::Time zero = view[3].time;
  std::array<double, 3> t{};
  Piece piece;
  for (int n = 0; n < 3; ++n) {
    t[static_cast<std::size_t>(n)] = world::seconds(view[first + n].time - zero);
    piece.time += t[static_cast<std::size_t>(n)] / 3;
    piece.middle += view[first + n].ball / 3;
  }
  for (int n = 0; n < 3; ++n) {
    const double dt = t[static_cast<std::size_t>(n)] - piece.time;
    piece.spread += dt * dt;
    piece.velocity += dt * view[first + n].ball;
  }
  piece.velocity /= piece.spread;
  for (int n = 0; n < 3; ++n) {
    piece.residual += (view[first + n].ball - piece.at(t[static_cast<std::size_t>(n)])).squaredNorm();
  }
  return piece;
}

}  // namespace

Broken fit(const View& view, double noise) {
  const Piece newer = piece(view, 0);
  const Piece older = piece(view, 3);
  Broken b;
  b.before = older.velocity;
  b.after = newer.velocity;
  b.sigma = noise * std::sqrt(1 / newer.spread + 1 / older.spread);
  b.seconds = newer.time - older.time;
  const double step = world::seconds(view[2].time - view[3].time);
  const Vector2d apart = older.at(0) - newer.at(0);
  const Vector2d change = b.before - b.after;
  const double speed2 = change.squaredNorm();
  b.share = speed2 > 1e-6 ? std::clamp(-apart.dot(change) / (speed2 * step), 0.0, 1.0) : 0.5;
  const Vector2d on_old = older.at(b.share * step);
  const Vector2d on_new = newer.at(b.share * step);
  b.place = (on_old + on_new) / 2;
  b.misfit = std::sqrt((newer.residual + older.residual + (on_old - on_new).squaredNorm()) / 3);
  return b;
}

double free_density(const Broken& b, double airborne, bool near, const LikelihoodParams& params) {
  Vector2d change = b.after - b.before;
  const double speed = b.before.norm();
  if (speed > 0) {  // friction takes between nothing and the most it can
    const Vector2d along = b.before / speed;
    change += along * std::clamp(-change.dot(along), 0.0, std::min(speed, params.slide * b.seconds));
  }
  const double n2 = change.squaredNorm();
  const double sigma = std::hypot(b.sigma, params.free_extra);
  const double air = std::clamp(airborne, 0.0, 1.0);
  const double hidden = near ? params.hidden_share : 0;
  const double ground =
      (1 - params.free_outliers) *
          ((1 - hidden) * gauss2(n2, sigma) + hidden * gauss2(n2, std::hypot(sigma, params.hidden_sigma))) +
      params.free_outliers * gauss2(n2, std::hypot(sigma, params.outlier_sigma));
  return (1 - air) * ground + air * gauss2(n2, std::hypot(sigma, params.air_sigma));
}

double contact_density(const Broken& b, const NearRobot& robot, double noise, double free,
                       const LikelihoodParams& p) {
  const double gap = robot.gap;
  const Vector2d& normal = robot.normal;
  const Vector2d change = b.after - b.before;
  const double along = change.dot(normal);
  const double across = change.x() * normal.y() - change.y() * normal.x();
  const double sigma = std::hypot(b.sigma, p.free_extra);
  const auto push = [&](double scale) {  // a half-normal, blurred by the noise
    const double width = std::hypot(scale, sigma);
    const double towards = 0.5 * std::erfc(-along * scale / (sigma * width * std::numbers::sqrt2));
    return ((1 - p.pull_share) * 2 * towards + p.pull_share) * gauss(along, width);
  };
  const double moved =
      (push(p.soft_push) + push(p.hard_push)) / 2 * gauss(across, std::hypot(sigma, 0.05, p.tangent * along));
  const double gap_sigma =
      std::hypot(p.gap_sigma + (gap < 0 ? p.inside_sigma : 0), noise, p.gap_per_speed * change.norm());
  const double at_hull =
      ((1 - p.far_share) * gauss(gap, gap_sigma) + p.far_share * gauss(gap, gap_sigma + p.far_sigma)) *
      p.visit;
  const double r = b.misfit / std::hypot(2 * noise, p.misfit_share * change.norm() * world::tick_length);
  const double passing = ((b.before + b.after) / 2 - robot.velocity).norm() / p.rest_speed;
  const double rest = p.rest_share * std::exp(-passing * passing / 2);
  const bool gripped = robot.at_dribbler && gap < p.grip_reach;
  const double grip = gripped ? p.grip_share * p.visit / p.grip_reach *
                                    gauss2(change.squaredNorm(), std::hypot(sigma, p.grip_pull))
                              : 0;
  return p.prior * grip +
         p.prior * at_hull * ((1 - p.rest_share) * moved / (1 + r * r * r * r / 16) + rest * free);
}

double passed_freely(const Course& before, const Course& after, double noise,
                     const LikelihoodParams& params) {
  const double dt = world::seconds(after.time - before.time);
  const double speed = before.velocity.norm();
  Vector2d change = after.velocity - before.velocity;
  const double sigma2 =
      noise * noise * (1 / before.spread + 1 / after.spread) + params.free_extra * params.free_extra;
  double off = 0;
  double blur2 = noise * noise / 2 + params.free_extra * params.free_extra * dt * dt +
                 noise * noise / before.spread * dt * dt;
  if (speed > 0.05) {
    const Vector2d along = before.velocity / speed;
    change += along * std::clamp(-change.dot(along), 0.0, std::min(speed, params.slide * dt));
    const Vector2d way = after.middle - before.middle;
    off = way.x() * along.y() - way.y() * along.x();
  } else {
    off = (after.middle - before.middle).norm();
  }
  const double chi2 = change.squaredNorm() / sigma2 + off * off / blur2;
  const double density = (1 - params.free_outliers) * std::exp(-chi2 / 2) / (2 * std::numbers::pi * sigma2);
  return density + params.free_outliers * gauss2(change.squaredNorm(), params.outlier_sigma);
}

double passage_changed(const Course& before, const Course& after, const LikelihoodParams& params) {
  const double n2 = (after.velocity - before.velocity).squaredNorm();
  return (gauss2(n2, params.soft_push) + gauss2(n2, params.hard_push)) / 2;
}

}  // namespace touch

#include "autoref/tracker/ball_filter.h"

#include <algorithm>
#include <cmath>

namespace tracker {
namespace {

/// Spectral density of a white acceleration that makes velocity wander by `a` times a frame in a frame.
double density(double a) { return a * a * world::tick_length; }

constexpr double least_weight = 1e-4;  // so that no phase is ever ruled out for good; ours

}  // namespace

BallFilter::BallFilter(const world::Geometry& geometry, const Params& params)
    : models_{BallModel{std::max(0.0, geometry.ball_slide_deceleration), density(params.sliding_noise)},
              BallModel{std::max(0.0, geometry.ball_roll_deceleration), density(params.rolling_noise)},
              BallModel{0, density(params.erratic_noise)}},
      measurement_variance_(params.ball_sigma * params.ball_sigma),
      r_(measurement_variance_),
      switch_ratio_(geometry.ball_switch_ratio) {}

void BallFilter::start(const Vector2d& position, const Vector2d& velocity, double velocity_sigma) {
  BallEkf belief;
  belief.position = position;
  belief.velocity = velocity;
  belief.position_cov = r_ * Matrix2d::Identity();
  belief.velocity_cov = velocity_sigma * velocity_sigma * Matrix2d::Identity();
  beliefs_.fill(belief);
  weights_ = {0.4, 0.4, 0.2};  // ours: the measurements decide within a few frames
}

void BallFilter::mix(double dt, bool near_robot) {
  // Chances per second of changing phase, ours: a 6 m/s kick slides for 0.6 s; near a robot contact begins in
  // every fifth frame and lasts about as long, elsewhere only chips and unseen robots disturb the ball.
  const double disturbed = near_robot ? 12 : 0.2;
  const double settles = near_robot ? 3 : 6;
  const auto chance = [dt](double rate) { return std::min(rate * dt, 0.3); };
  const double change[phases][phases] = {{0, chance(2), chance(disturbed)},
                                         {chance(0.1), 0, chance(disturbed)},
                                         {chance(settles), chance(settles), 0}};

  std::array<std::array<double, phases>, phases> share;  // of the old phase i in the new phase j
  std::array<double, phases> weights{};
  for (int j = 0; j < phases; ++j) {
    for (int i = 0; i < phases; ++i) {
      const double p = i == j ? 1 - change[i][0] - change[i][1] - change[i][2] : change[i][j];
      share[j][i] = p * weights_[i];
      weights[j] += share[j][i];
    }
  }

  const std::array<BallEkf, phases> old = beliefs_;
  for (int j = 0; j < phases; ++j) {
    BallEkf& belief = beliefs_[j];
    belief.position.setZero();
    belief.velocity.setZero();
    for (int i = 0; i < phases; ++i) {
      share[j][i] /= weights[j];
      belief.position += share[j][i] * old[i].position;
      belief.velocity += share[j][i] * old[i].velocity;
    }
    belief.position_cov.setZero();
    belief.cross_cov.setZero();
    belief.velocity_cov.setZero();
    for (int i = 0; i < phases; ++i) {
      const Vector2d dp = old[i].position - belief.position;
      const Vector2d dv = old[i].velocity - belief.velocity;
      belief.position_cov += share[j][i] * (old[i].position_cov + dp * dp.transpose());
      belief.cross_cov += share[j][i] * (old[i].cross_cov + dp * dv.transpose());
      belief.velocity_cov += share[j][i] * (old[i].velocity_cov + dv * dv.transpose());
    }
  }
  weights_ = weights;
}

void BallFilter::predict(double dt, bool near_robot) {
  mix(dt, near_robot);
  for (int i = 0; i < phases; ++i) beliefs_[i].predict(dt, models_[i]);
}

double BallFilter::best_nis(const Vector2d& measured) const {
  double best = 0;
  for (int i = 0; i < phases; ++i) {
    Matrix2d s = beliefs_[i].position_cov;
    s.diagonal().array() += r_;
    const double value = normalised_square(measured - beliefs_[i].position, s);
    if (i == 0 || value < best) best = value;
  }
  return best;
}

double BallFilter::nis(const Vector2d& measured) const {
  const Vector2d mean = position();
  Matrix2d s = r_ * Matrix2d::Identity();
  for (int i = 0; i < phases; ++i) {
    const Vector2d spread = beliefs_[i].position - mean;
    s += weights_[i] * (beliefs_[i].position_cov + spread * spread.transpose());
  }
  return normalised_square(measured - mean, s);
}

void BallFilter::update(const Vector2d& measured) {
  double sum = 0;
  for (int i = 0; i < phases; ++i) {
    weights_[i] *= beliefs_[i].update(measured, r_);
    sum += weights_[i];
  }
  if (!(sum > 0)) {  // every likelihood underflowed: the widest model is the least wrong
    weights_ = {0, 0, 1};
    sum = 1;
  }
  double floored = 0;
  for (double& weight : weights_) floored += weight = std::max(weight / sum, least_weight);
  for (double& weight : weights_) weight /= floored;
}

BallFilter::Motion BallFilter::foretell(double dt) const {
  Motion mean;
  std::array<Vector2d, phases> places;
  for (int i = 0; i < phases; ++i) {
    const BallEkf& now = beliefs_[i];
    const double speed = now.velocity.norm();
    const double slide = models_[Slide].deceleration;
    const double roll = models_[Roll].deceleration;
    const double slide_time = i == Slide ? std::min(dt, (1 - switch_ratio_) * speed / slide) : 0;
    const double roll_speed = speed - slide * slide_time;
    const double roll_time = std::min(dt - slide_time, roll_speed / roll);
    const double way =
        (speed + roll_speed) / 2 * slide_time + (roll_speed - roll * roll_time / 2) * roll_time;
    places[i] = now.position;
    if (speed > 0) {
      places[i] += now.velocity * (way / speed);
      mean.velocity += weights_[i] * now.velocity * ((roll_speed - roll * roll_time) / speed);
    }
    mean.position += weights_[i] * places[i];
  }
  Vector2d variance = Vector2d::Zero();
  for (int i = 0; i < phases; ++i) {
    const BallEkf& now = beliefs_[i];
    const double noise = models_[i].noise * dt * dt * dt / 3;
    for (int axis = 0; axis < 2; ++axis) {
      const double off = places[i][axis] - mean.position[axis];
      variance[axis] += weights_[i] * (now.position_cov(axis, axis) + 2 * dt * now.cross_cov(axis, axis) +
                                       dt * dt * now.velocity_cov(axis, axis) + noise + off * off);
    }
  }
  mean.sigma = std::sqrt(variance.maxCoeff());
  return mean;
}

Vector2d BallFilter::position() const {
  Vector2d mean = Vector2d::Zero();
  for (int i = 0; i < phases; ++i) mean += weights_[i] * beliefs_[i].position;
  return mean;
}

double BallFilter::velocity_variance() const {
  const Vector2d mean = velocity();
  Vector2d variance = Vector2d::Zero();
  for (int i = 0; i < phases; ++i) {
    const Vector2d off = beliefs_[i].velocity - mean;
    variance += weights_[i] * (beliefs_[i].velocity_cov.diagonal() + off.cwiseAbs2());
  }
  return variance.maxCoeff();
}

Vector2d BallFilter::velocity() const {
  Vector2d mean = Vector2d::Zero();
  for (int i = 0; i < phases; ++i) mean += weights_[i] * beliefs_[i].velocity;
  return mean;
}

}  // namespace tracker

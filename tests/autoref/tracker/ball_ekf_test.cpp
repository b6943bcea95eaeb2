#include "autoref/tracker/ball_ekf.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

namespace tracker {
namespace {

using Matrix4d = Eigen::Matrix4d;

BallEkf moving_ball() {
  BallEkf ball;
  ball.position = {0.3, -0.2};
  ball.velocity = {1.2, -0.5};
  ball.position_cov << 4e-6, 1e-6, 1e-6, 3e-6;
  ball.cross_cov << 2e-5, 1e-6, -2e-6, 1e-5;
  ball.velocity_cov << 4e-3, 1e-3, 1e-3, 2e-3;
  return ball;
}

Matrix4d covariance(const BallEkf& ball) {
  Matrix4d p;
  p << ball.position_cov, ball.cross_cov, ball.cross_cov.transpose(), ball.velocity_cov;
  return p;
}

TEST(BallEkf, RollsAsInTheClosedForm) {
  BallEkf ball = moving_ball();
  ball.predict(0.5, {0.26, 0});
  // s = v t - a t^2 / 2 along the direction of motion; speed falls by a t. Only rounding differs.
  EXPECT_NEAR(ball.velocity.norm(), 1.3 - 0.13, 1e-12);
  EXPECT_NEAR((ball.position - Vector2d(0.3, -0.2)).norm(), 1.3 * 0.5 - 0.13 * 0.25, 1e-12);
}

TEST(BallEkf, StopsWhereEnergyEnds) {
  BallEkf ball = moving_ball();
  ball.predict(100, {0.26, 0});
  EXPECT_EQ(ball.velocity, Vector2d(0, 0));
  EXPECT_NEAR((ball.position - Vector2d(0.3, -0.2)).norm(), 1.3 * 1.3 / (2 * 0.26), 1e-12);  // v^2 / 2a
}

TEST(BallEkf, OneStepIsTwoHalfSteps) {
  BallEkf once = moving_ball();
  BallEkf twice = once;
  once.predict(0.2, {3, 0});
  twice.predict(0.1, {3, 0});
  twice.predict(0.1, {3, 0});
  EXPECT_LT((once.position - twice.position).norm(), 1e-12);
  EXPECT_LT((once.velocity - twice.velocity).norm(), 1e-12);
}

TEST(BallEkf, JacobianIsThatOfTheMotion) {
  for (const double dt : {0.01, 0.4, 0.6}) {  // in the last the ball stops on the way (1.3 m/s at 3 m/s^2)
    const BallModel model{3, 0};
    Matrix4d f;  // by central differences
    for (int column = 0; column < 4; ++column) {
      constexpr double h = 1e-6;
      BallEkf plus = moving_ball();
      BallEkf minus = plus;
      (column < 2 ? plus.position : plus.velocity)[column % 2] += h;
      (column < 2 ? minus.position : minus.velocity)[column % 2] -= h;
      plus.predict(dt, model);
      minus.predict(dt, model);
      f.col(column) << (plus.position - minus.position) / (2 * h), (plus.velocity - minus.velocity) / (2 * h);
    }
    BallEkf ball = moving_ball();
    const Matrix4d expected = f * covariance(ball) * f.transpose();
    ball.predict(dt, model);
    // Central differences err by h^2 times the third derivative: 1e-12 of the largest
    // entry, 4e-3; factor 100.
    EXPECT_LT((covariance(ball) - expected).cwiseAbs().maxCoeff(), 1e-11) << "dt " << dt;
  }
}

TEST(BallEkf, FreeFlightGrowsByIntegratedWhiteNoise) {
  BallEkf ball;
  ball.predict(0.5, {0, 2});
  // integral of q: vv = q t, pv = q t^2 / 2, pp = q t^3 / 3.
  EXPECT_NEAR(ball.velocity_cov(0, 0), 1.0, 1e-15);
  EXPECT_NEAR(ball.cross_cov(1, 1), 0.25, 1e-15);
  EXPECT_NEAR(ball.position_cov(0, 0), 2 * 0.125 / 3, 1e-15);
}

TEST(BallEkf, GainIsTheClosedForm) {
  BallEkf ball = moving_ball();
  const Matrix4d p = covariance(ball);
  const double r = 1e-6;
  const Vector2d measured(0.301, -0.2005);

  // The textbook's K = P H' (H P H' + R)^-1 and Joseph's form, on the whole 4 x 4 matrix.
  Eigen::Matrix<double, 2, 4> h = Eigen::Matrix<double, 2, 4>::Zero();
  h(0, 0) = h(1, 1) = 1;
  const Matrix2d s = h * p * h.transpose() + r * Matrix2d::Identity();
  const Eigen::Matrix<double, 4, 2> k = p * h.transpose() * s.inverse();
  const Matrix4d a = Matrix4d::Identity() - k * h;
  const Matrix4d expected = a * p * a.transpose() + k * k.transpose() * r;
  Eigen::Vector4d state;
  state << ball.position, ball.velocity;
  state += k * (measured - ball.position);
  const double nis = (measured - ball.position).dot(s.inverse() * (measured - ball.position));
  const double likelihood = std::exp(-nis / 2) / (2 * M_PI * std::sqrt(s.determinant()));

  EXPECT_NEAR(ball.update(measured, r) / likelihood, 1, 1e-12);
  EXPECT_LT((ball.position - state.head<2>()).norm(), 1e-12);
  EXPECT_LT((ball.velocity - state.tail<2>()).norm(), 1e-12);
  EXPECT_LT((covariance(ball) - expected).cwiseAbs().maxCoeff(), 1e-15);  // entries up to 4e-3: rounding
}

TEST(BallEkf, ManySightingsOfABallAtRestAverage) {
  BallEkf ball;
  ball.position_cov = 1e6 * Matrix2d::Identity();
  double sum = 0;
  for (int n = 1; n <= 10; ++n) {
    const double x = 0.01 * n;
    sum += x;
    ball.predict(0, {0.26, 0.1});
    ball.update({x, 0}, 1e-4);
  }
  EXPECT_NEAR(ball.position.x(), sum / 10, 1e-9);          // the prior weighs 1e-10
  EXPECT_NEAR(ball.position_cov(0, 0), 1e-4 / 10, 1e-13);  // r / n
}

}  // namespace
}  // namespace tracker

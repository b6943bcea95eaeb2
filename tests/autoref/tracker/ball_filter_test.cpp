#include "autoref/tracker/ball_filter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "sim/world/random.h"
#include "tests/autoref/tracker/synthetic.h"

namespace tracker {
namespace {

constexpr double frame = 1.0 / 60;

struct Honesty {
  double mean = 0;          // NIS per degree of freedom
  double above = 0;         // share above the 99.9 % bound
  double speed_rms = 0;     // [m/s]
  double position_rms = 0;  // [m]
};

/// Follows 200 balls for 2 s each from the third sighting on.
/// @param settle  frames not counted at the start
Honesty follow(bool slides, double min_speed, double max_speed, int settle) {
  const Params params;
  world::RandomStream stream(3, "balls");
  Honesty result;
  int count = 0;
  for (int n = 0; n < 200; ++n) {
    const double speed = min_speed + (max_speed - min_speed) * stream.uniform();
    const synthetic::GroundBall ball{{0, 0}, speed * world::direction(6.28 * stream.uniform()), slides};
    BallFilter filter(world::Geometry{}, params);
    filter.start(ball.position(0), ball.kick, 1.0);
    for (int k = 1; k < 120; ++k) {
      Vector2d z = ball.position(k * frame);
      z.x() += params.ball_sigma * stream.gaussian();
      z.y() += params.ball_sigma * stream.gaussian();
      filter.predict(frame, false);
      const double nis = filter.nis(z);
      filter.update(z);
      if (k <= settle) continue;
      result.mean += nis / 2;
      result.above += nis > 13.816;
      result.speed_rms += (filter.velocity() - ball.velocity(k * frame)).squaredNorm();
      result.position_rms += (filter.position() - ball.position(k * frame)).squaredNorm();
      ++count;
    }
  }
  result.mean /= count;
  result.above /= count;
  result.speed_rms = std::sqrt(result.speed_rms / count);
  result.position_rms = std::sqrt(result.position_rms / count);
  std::cout << (slides ? "kicked" : "rolling") << " ball " << min_speed << ".." << max_speed
            << " m/s: mean NIS " << result.mean << ", above 99.9 %: " << 100 * result.above
            << " %, velocity rms " << result.speed_rms << " m/s, position rms " << 1000 * result.position_rms
            << " mm\n";
  return result;
}

// Bands of issue 4. 200 balls of 2 s: 22 000 innovations, so the mean scatters by 0.7 % by itself.
TEST(BallFilter, IsHonestForFreelyRollingBalls) {
  const Honesty honesty = follow(false, 0.5, 6, 5);
  EXPECT_GT(honesty.mean, 0.8);
  EXPECT_LT(honesty.mean, 1.25);
  EXPECT_LE(honesty.above, 0.01);
  EXPECT_LT(honesty.speed_rms, 0.05);       // measured 0.02 m/s
  EXPECT_LT(honesty.position_rms, 0.0007);  // one raw measurement: 0.5 mm x sqrt 2
}

TEST(BallFilter, IsHonestForBallsThatStopOnTheWay) {
  const Honesty honesty = follow(false, 0.0, 0.4, 5);
  EXPECT_GT(honesty.mean, 0.8);
  EXPECT_LT(honesty.mean, 1.25);
  EXPECT_LE(honesty.above, 0.01);
}

TEST(BallFilter, IsHonestForKickedBallsThroughSlidingAndRolling) {
  const Honesty honesty = follow(true, 2, 8, 5);
  EXPECT_GT(honesty.mean, 0.8);
  EXPECT_LT(honesty.mean, 1.25);
  EXPECT_LE(honesty.above, 0.01);
  EXPECT_LT(honesty.speed_rms, 0.1);
}

TEST(BallFilter, TellsSlidingFromRolling) {
  for (const bool slides : {true, false}) {
    const synthetic::GroundBall ball{{0, 0}, {6, 0}, slides};  // slides for 0.57 s
    BallFilter filter(world::Geometry{}, Params{});
    filter.start(ball.position(0), {6, 0}, 1.0);
    for (int k = 1; k <= 24; ++k) {
      filter.predict(frame, false);
      filter.update(ball.position(k * frame));
    }
    EXPECT_GT(filter.weight(slides ? BallFilter::Slide : BallFilter::Roll), 0.9);
  }
}

TEST(BallFilter, WeightsStayProbabilities) {
  BallFilter filter(world::Geometry{}, Params{});
  filter.start({0, 0}, {0, 0}, 1);
  for (int k = 1; k < 50; ++k) {
    filter.predict(frame, k % 2 == 0);
    filter.update({k % 7 == 0 ? 40.0 : 0.0, 0});  // likelihoods that underflow
    double sum = 0;
    for (int phase = 0; phase < BallFilter::phases; ++phase) {
      const double weight = filter.weight(static_cast<BallFilter::Phase>(phase));
      EXPECT_GT(weight, 0);
      sum += weight;
    }
    EXPECT_NEAR(sum, 1, 1e-12);
    EXPECT_TRUE(filter.position().allFinite());
  }
}

}  // namespace
}  // namespace tracker

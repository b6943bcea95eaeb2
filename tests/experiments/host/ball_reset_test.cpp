#include "experiments/host/ball_reset.h"

#include <gtest/gtest.h>

#include "sim/engine/realism.h"

namespace host {
namespace {

using world::Vector2d;

class BallResetTest : public testing::Test {
 protected:
  BallResetTest() : engine_(model()) {
    state_.location = world::Location::GameOff;
    state_.command.kind = world::CommandKind::Stop;
  }

  static engine::Model model() {
    engine::Model model;
    model.robots.yellow = engine::standard_robots(world::Team::Yellow, {0});
    model.robots.blue = engine::standard_robots(world::Team::Blue, {0});
    model.realism = engine::realism("none");
    return model;
  }

  // Steps until the ball is put somewhere; seconds waited, or nothing within `limit` seconds.
  std::optional<double> wait_for_reset(std::optional<Vector2d> wish, double limit) {
    const double begin = world::seconds(engine_.time());
    while (world::seconds(engine_.time()) - begin < limit) {
      engine_.step({});
      const auto spot = reset_.update(wish, state_, engine_);
      wish.reset();
      if (spot) return world::seconds(engine_.time()) - begin;
    }
    return std::nullopt;
  }

  engine::Engine engine_;
  world::GameState state_;
  BallReset reset_;
};

const Vector2d spot{2, 1};

TEST_F(BallResetTest, WaitsHalfASecondAfterTheCommand) {
  state_.command_time = engine_.time();
  const auto waited = wait_for_reset(spot, 5);
  ASSERT_TRUE(waited);
  EXPECT_NEAR(*waited, 0.5, world::tick_length);
  EXPECT_LT((engine_.truth().ball.position.head<2>() - spot).norm(), 1e-6);  // float of Bullet
}

TEST_F(BallResetTest, DoesNotWaitAgainWhenTheCommandIsLongAgo) {
  state_.command_time = engine_.time();
  for (int i = 0; i < world::ticks_per_second; ++i) engine_.step({});
  const auto waited = wait_for_reset(spot, 5);
  ASSERT_TRUE(waited);
  EXPECT_NEAR(*waited, world::tick_length, 1e-6);
}

TEST_F(BallResetTest, MovesARobotAwayAfterThreeSeconds) {
  engine_.put_robot({world::Team::Yellow, 0}, spot + Vector2d{0.2, 0},
                    0);  // its hull is 0.11 m from the spot
  state_.command_time = engine_.time();
  const auto waited = wait_for_reset(spot, 5);
  ASSERT_TRUE(waited);
  // The wish comes with the first tick.
  EXPECT_NEAR(*waited, 3 + world::tick_length, 1e-6);
  EXPECT_TRUE(engine_.spot_is_free(spot, BallReset::clearance - 1e-3));  // 1 mm: float of Bullet
}

TEST_F(BallResetTest, ARepeatedWishDoesNotStartTheWaitingAnew) {
  engine_.put_robot({world::Team::Yellow, 0}, spot, 0);
  state_.command_time = engine_.time();
  EXPECT_FALSE(wait_for_reset(spot, 2));
  const auto waited = wait_for_reset(spot, 5);
  ASSERT_TRUE(waited);
  EXPECT_NEAR(*waited, 1 + world::tick_length, 2 * world::tick_length);
}

TEST_F(BallResetTest, PutsTheBallAsSoonAsTheRobotHasGone) {
  engine_.put_robot({world::Team::Yellow, 0}, spot, 0);
  state_.command_time = engine_.time();
  EXPECT_FALSE(wait_for_reset(spot, 1));
  engine_.put_robot({world::Team::Yellow, 0}, {-2, -1}, 0);
  const auto waited = wait_for_reset(std::nullopt, 5);
  ASSERT_TRUE(waited);
  EXPECT_NEAR(*waited, world::tick_length, 1e-6);
}

TEST_F(BallResetTest, ForgetsTheWishWhenPlayGoesOn) {
  engine_.put_robot({world::Team::Yellow, 0}, spot, 0);
  EXPECT_FALSE(wait_for_reset(spot, 1));
  state_.location = world::Location::GameOn;
  EXPECT_FALSE(wait_for_reset(std::nullopt, 5));
}

}  // namespace
}  // namespace host

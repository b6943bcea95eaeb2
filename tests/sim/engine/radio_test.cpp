#include "sim/engine/radio.h"

#include <gtest/gtest.h>

#include <cmath>

namespace engine {
namespace {

constexpr world::RobotId robot{world::Team::Blue, 3};

world::RobotCommand forward(double speed) {
  return {.number = 3, .velocity_local = {speed, 0}, .kick_speed = 4, .dribbler_speed = 100};
}

TEST(RobotRadio, WithoutLossesHearsWhatIsSentAndStopsWhenNothingIs) {
  RobotRadio radio(robot, {}, 1);
  radio.begin_tick();
  radio.send(forward(1));
  EXPECT_EQ(radio.heard().velocity_local.x(), 1);
  EXPECT_EQ(radio.heard().kick_speed, 4);
  radio.begin_tick();
  EXPECT_EQ(radio.heard().velocity_local.x(), 0);
  EXPECT_EQ(radio.heard().number, 3);
}

TEST(RobotRadio, GoesOnWithoutKickingUntilItsTimeout) {
  RobotRadio radio(robot, {.loss = 0, .timeout = 3}, 1);
  radio.begin_tick();
  radio.send(forward(1));
  // From now on everything is lost: a radio of the same state with a certain loss.
  RobotRadio deaf(robot, {.loss = 1, .timeout = 3}, 1);
  deaf.begin_tick();
  deaf.send(forward(1));
  EXPECT_EQ(deaf.heard().velocity_local.x(), 0) << "it has never heard anything";

  // Losses are drawn, so a loss of 0.5 is followed until three come in a row.
  RobotRadio half(robot, {.loss = 0.5, .timeout = 3}, 1);
  int silent = 1000;
  double last = 0;
  int stopped = 0;
  for (int tick = 0; tick < 1000; ++tick) {
    half.begin_tick();
    half.send(forward(tick));
    if (half.heard().kick_speed > 0) {
      EXPECT_EQ(half.heard().velocity_local.x(), tick);
      silent = 0;
      last = tick;
      continue;
    }
    ++silent;
    if (silent > 3) ++stopped;
    EXPECT_EQ(half.heard().velocity_local.x(), silent <= 3 ? last : 0) << tick;
  }
  EXPECT_GT(stopped, 10);  // 1000/16 runs of four losses on average
}

TEST(RobotRadio, LosesTheShareItIsAskedToAndEachRobotAnother) {
  const int ticks = 20'000;
  const double loss = 0.03;
  RobotRadio one(robot, {.loss = loss, .timeout = 0}, 1);
  RobotRadio other({world::Team::Yellow, 3}, {.loss = loss, .timeout = 0}, 1);
  int lost_one = 0;
  int lost_both = 0;
  for (int tick = 0; tick < ticks; ++tick) {
    for (RobotRadio* radio : {&one, &other}) {
      radio->begin_tick();
      radio->send(forward(1));
    }
    const bool lost = one.heard().kick_speed == 0;
    lost_one += lost;
    lost_both += lost && other.heard().kick_speed == 0;
  }
  const double sigma = std::sqrt(ticks * loss * (1 - loss));  // of a binomial number
  EXPECT_NEAR(lost_one, ticks * loss, 4 * sigma);
  const double both = ticks * loss * loss;
  EXPECT_NEAR(lost_both, both, 4 * std::sqrt(both));
}

}  // namespace
}  // namespace engine

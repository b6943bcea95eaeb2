#include "experiments/stats/power.h"

#include <gtest/gtest.h>

#include <cmath>

namespace stats {
namespace {

// Harness reference 2.6, printed with three decimals.
TEST(DetectableEffect, GivesThePrintedTable) {
  EXPECT_NEAR(detectable_effect(50), 0.396, 5e-4);
  EXPECT_NEAR(detectable_effect(100), 0.280, 5e-4);
  EXPECT_NEAR(detectable_effect(300), 0.162, 5e-4);
  EXPECT_NEAR(detectable_effect(5000), 0.040, 5e-4);
}

TEST(NeededForEffect, GivesThePrintedTable) {
  EXPECT_EQ(needed_for_effect(0.255), 121);
  EXPECT_EQ(needed_for_effect(0.268), 110);
  EXPECT_NEAR(static_cast<double>(needed_for_effect(0.255, {.level = 0.05, .power = 0.9})), 162, 1);
}

TEST(Power, OfTheDetectableEffectIsTheOneAskedFor) {
  // The other tail adds less than 1e-5.
  EXPECT_NEAR(power_of(80, detectable_effect(80)), 0.8, 1e-5);
  EXPECT_NEAR(power_of(80, 0), 0.05, 1e-12) << "without an effect only false alarms";
}

TEST(GoalDifference, GoesThereAndBack) {
  const double difference = detectable_goal_difference(90, 2.5, 0.1);
  EXPECT_NEAR(static_cast<double>(pairs_for_goal_difference(difference, 2.5, 0.1)), 90, 1);
  EXPECT_NEAR(difference, detectable_effect(90) * 2.5 * std::sqrt(1.1 / 2), 1e-12);
}

TEST(GoalDifference, NeedsFewerPairsWhenTheirGamesAreOpposed) {
  EXPECT_LT(pairs_for_goal_difference(0.5, 2, -0.15), pairs_for_goal_difference(0.5, 2, 0));
}

TEST(WinShare, GoesThereAndBack) {
  const double difference = detectable_win_share(90, 0.3);
  EXPECT_NEAR(static_cast<double>(pairs_for_win_share(difference, 0.3)), 90, 1);
}

TEST(WinShare, IsNeverMoreThanThereIsToWin) {
  EXPECT_LE(detectable_win_share(1, 0.5), 0.5);
  EXPECT_EQ(pairs_for_win_share(0.7, 0.3), 2) << "a team that wins every game that is not drawn";
}

}  // namespace
}  // namespace stats

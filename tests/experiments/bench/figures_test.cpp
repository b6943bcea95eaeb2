#include "experiments/bench/figures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>

namespace bench {
namespace {

using testing::HasSubstr;

TEST(Row, HasMeanMedianAndTheValueThatOnePercentExceed) {
  std::vector<double> values(101);
  std::iota(values.rbegin(), values.rend(), 0.0);  // 100 down to 0
  values[0] = 1000;                                // the largest one, instead of 100
  const Row row = row_of("part", values);
  EXPECT_DOUBLE_EQ(row.mean, (4950.0 + 1000.0) / 101);
  EXPECT_DOUBLE_EQ(row.median, 50);
  EXPECT_DOUBLE_EQ(row.ninety_nine, 99);
}

TEST(Row, OfNothingIsEmpty) { EXPECT_EQ(row_of("part", {}).mean, 0); }

Figures example() {
  Figures figures;
  figures.ticks = 6000;      // 100 s of the game
  figures.loop_seconds = 2;  // of wall time
  figures.host_cpu = 0.75;
  figures.teams_cpu = 0.5;
  figures.reference_tick = 25e-6;
  figures.rows = {{"physics", 30e-6, 20e-6, 90e-6}, {"channel", 10e-6}};
  figures.sum = 40e-6;
  return figures;
}

TEST(Figures, TimesRealTimeIsSimulatedOverWallAndOverProcessorTime) {
  EXPECT_DOUBLE_EQ(example().times_real_time(), 50);
  EXPECT_DOUBLE_EQ(example().times_real_time_cpu(), 80);
}

TEST(Figures, TableAndJsonShowEachPartAlsoAsARatioToTheReferenceScene) {
  EXPECT_THAT(table(example()), HasSubstr("physics                 30.0    20.0    90.0    1.20\n"));
  EXPECT_THAT(table(example()), HasSubstr("channel                 10.0                    0.40\n"));
  EXPECT_THAT(table(example()), HasSubstr("times real time per core  50 "));
  EXPECT_THAT(json(example()), HasSubstr("\"of_reference\": 0.4"));
}

TEST(Figures, ShowGamesPerHourOnlyWhenTheyWereMeasured) {
  EXPECT_THAT(table(example()), testing::Not(HasSubstr("games per hour")));
  Figures figures = example();
  figures.scaling = Scaling{2, 500, 990};
  EXPECT_THAT(table(figures), HasSubstr("500 with 1 worker, 990 with 2, 1.98 times as many\n"));
}

}  // namespace
}  // namespace bench

#include "experiments/host/stopwatch.h"

#include <gtest/gtest.h>

#include <thread>

namespace host {
namespace {

using namespace std::chrono_literals;

TEST(Stopwatch, BooksEachLapUnderItsPart) {
  Stopwatch stopwatch;
  stopwatch.begin_tick();
  std::this_thread::sleep_for(20ms);
  stopwatch.part_of_lap(Part::Vision, 5ms);
  stopwatch.lap(Part::Physics);
  stopwatch.lap(Part::Referee);
  EXPECT_DOUBLE_EQ(stopwatch.mean(Part::Vision), static_cast<double>(0.005F));  // kept as float
  EXPECT_GE(stopwatch.mean(Part::Physics), 0.015 - 1e-6);
  EXPECT_LT(stopwatch.mean(Part::Referee), 0.005);  // nothing happened in it
  stopwatch.begin_tick();
  EXPECT_EQ(stopwatch.times(Part::Vision).size(), 2U);
  EXPECT_EQ(stopwatch.times(Part::Vision)[1], 0.0);
}

}  // namespace
}  // namespace host

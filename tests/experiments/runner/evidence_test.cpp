#include "experiments/runner/evidence.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/experiments/runner/support.h"

namespace runner {
namespace {

namespace fs = std::filesystem;

class EvidenceTest : public testing::Test {
 protected:
  /// An attempt with a file of so many bytes.
  record::Attempt attempt(int pair, bool faulty, std::size_t bytes) const {
    record::Attempt attempt;
    attempt.key = {"equal", pair, 0};
    attempt.record.termination = record::Termination::Finished;
    attempt.record.at_fault = faulty ? record::Party::Blue : record::Party::Nobody;
    fs::create_directories(place(pair));
    std::ofstream(place(pair) / "log") << std::string(bytes, 'x');
    return attempt;
  }
  fs::path place(int pair) const { return folder_.game(record::game_id({"equal", pair, 0}), 1); }

  TemporaryFolder temporary_;
  ResultFolder folder_{temporary_.path() / "a"};
};

TEST_F(EvidenceTest, KeepsFaultyAndSampledGamesOnly) {
  Evidence evidence(folder_, 1000, {});
  evidence.ended(attempt(1, false, 10), false);
  evidence.ended(attempt(2, false, 10), true);
  evidence.ended(attempt(3, true, 10), false);
  EXPECT_FALSE(fs::exists(place(1)));
  EXPECT_TRUE(fs::exists(place(2)));
  EXPECT_TRUE(fs::exists(place(3)));
  EXPECT_EQ(evidence.size(), 20);
}

TEST_F(EvidenceTest, DropsTheOldestSampledGamesFirst) {
  Evidence evidence(folder_, 100, {});
  evidence.ended(attempt(1, true, 40), false);
  evidence.ended(attempt(2, false, 30), true);
  EXPECT_EQ(evidence.ended(attempt(3, false, 30), true), 0U);
  EXPECT_EQ(evidence.ended(attempt(4, true, 30), false), 1U);
  EXPECT_FALSE(fs::exists(place(2)));
  EXPECT_EQ(evidence.ended(attempt(5, true, 60), false), 2U) << "then the faulty ones";
  EXPECT_FALSE(fs::exists(place(1)));
  EXPECT_FALSE(fs::exists(place(3)));
  EXPECT_EQ(evidence.size(), 90);
}

TEST_F(EvidenceTest, TakesInWhatEarlierRunsKept) {
  const std::vector<record::Attempt> before = {attempt(1, true, 40), attempt(2, false, 30)};
  Evidence evidence(folder_, 80, before);
  EXPECT_EQ(evidence.size(), 70);
  evidence.ended(attempt(3, true, 30), false);
  EXPECT_TRUE(fs::exists(place(1)));
  EXPECT_FALSE(fs::exists(place(2)));
}

TEST(SamplingNumber, IsEvenlySpreadAndTheSameInEveryRun) {
  int below = 0;
  for (int pair = 0; pair < 10'000; ++pair) {
    const record::GameKey key{"equal", pair, 0};
    const double number = sampling_number("experiment", key);
    ASSERT_GE(number, 0);
    ASSERT_LT(number, 1);
    ASSERT_EQ(number, sampling_number("experiment", key));
    below += number < 0.01 ? 1 : 0;
  }
  EXPECT_NEAR(below, 100, 40);  // four standard deviations of a count of 100
  EXPECT_NE(sampling_number("one", {"equal", 1, 0}), sampling_number("another", {"equal", 1, 0}));
}

}  // namespace
}  // namespace runner

#include "experiments/runner/evidence.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "experiments/record/checksum.h"
#include "tests/experiments/runner/support.h"
#include "tests/fakes/odd_files.h"

namespace runner {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;

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
  static std::vector<std::string> gone(const std::vector<Evidence::Place>& places) {
    std::vector<std::string> names;
    for (const Evidence::Place& one : places) names.push_back(one.game);
    return names;
  }
  fs::path place(int pair) const { return folder_.game(record::game_id({"equal", pair, 0}), 1); }

  TemporaryFolder temporary_;
  ResultFolder folder_{temporary_.path() / "a"};
};

TEST_F(EvidenceTest, KeepsFaultyAndSampledGamesOnly) {
  Evidence evidence(folder_, 1000, {});
  EXPECT_FALSE(Evidence::keeps(attempt(1, false, 10), false));
  EXPECT_TRUE(Evidence::keeps(attempt(2, false, 10), true));
  EXPECT_TRUE(Evidence::keeps(attempt(3, true, 10), false));
  evidence.add(attempt(2, false, 10));
  evidence.add(attempt(3, true, 10));
  EXPECT_EQ(evidence.size(), 20);
}

TEST_F(EvidenceTest, DropsTheOldestSampledGamesFirst) {
  Evidence evidence(folder_, 100, {});
  EXPECT_THAT(gone(evidence.add(attempt(1, true, 40))), IsEmpty());
  EXPECT_THAT(gone(evidence.add(attempt(2, false, 30))), IsEmpty());
  EXPECT_THAT(gone(evidence.add(attempt(3, false, 30))), IsEmpty());
  EXPECT_THAT(gone(evidence.add(attempt(4, true, 30))), ElementsAre("equal-0002-0"));
  EXPECT_THAT(gone(evidence.add(attempt(5, true, 60))), ElementsAre("equal-0003-0", "equal-0001-0"))
      << "then the faulty ones";
  EXPECT_EQ(evidence.size(), 90);
}

TEST_F(EvidenceTest, TakesInWhatEarlierRunsKept) {
  const std::vector<record::Attempt> before = {attempt(1, true, 40), attempt(2, false, 30)};
  Evidence evidence(folder_, 80, before);
  EXPECT_EQ(evidence.size(), 70);
  EXPECT_THAT(gone(evidence.add(attempt(3, true, 30))), ElementsAre("equal-0002-0"));
}

TEST_F(EvidenceTest, NamesSizesAndChecksumsOfFiles) {
  attempt(1, true, 40);
  fs::create_directories(place(1) / "deeper");
  std::ofstream(place(1) / "deeper/empty").close();
  EXPECT_THAT(
      files_in(folder_.path(), place(1)),
      ElementsAre(record::KeptFile{"games/equal-0001-0/1/deeper/empty", 0, record::checksum("")},
                  record::KeptFile{"games/equal-0001-0/1/log", 40, record::checksum(std::string(40, 'x'))}));
  EXPECT_THAT(files_in(folder_.path(), place(2)), IsEmpty());
}

TEST_F(EvidenceTest, CutsDownWhatIsTooLongLongestFilesOfTeamsFirst) {
  attempt(1, true, 40);
  fs::create_directories(place(1) / "yellow/deeper");
  std::ofstream(place(1) / "yellow/deeper/small") << "x";
  std::ofstream(place(1) / "yellow/long").close();
  fs::resize_file(place(1) / "yellow/long", std::uintmax_t{1} << 40);  // holes only
  EXPECT_EQ(cut_down(place(1)),
            "1 file of 1048576 MiB in its folder was removed: a game keeps at most 2048 MiB");
  EXPECT_EQ(cut_down(place(1)), "");
  EXPECT_EQ(files_in(folder_.path(), place(1)).size(), 2U);
  fs::resize_file(place(1) / "log", std::uintmax_t{3} << 30);
  EXPECT_EQ(cut_down(place(1)), "1 file of 3072 MiB in its folder was removed: a game keeps at most 2048 MiB")
      << "one of ours too";
  EXPECT_TRUE(fs::exists(place(1) / "yellow/deeper/small"));
}

TEST_F(EvidenceTest, CutsDownTooManyFiles) {
  attempt(1, true, 40);
  fs::create_directories(place(1) / "yellow");
  for (int i = 0; i < 20; ++i) std::ofstream(place(1) / "yellow" / std::to_string(i)) << "x";
  EXPECT_EQ(cut_down(place(1), {.files = 30}), "");
  EXPECT_EQ(cut_down(place(1), {.files = 10}),
            "what the teams wrote was removed: a game keeps at most 10 files");
  EXPECT_EQ(files_in(folder_.path(), place(1)).size(), 1U);
}

// A team may leave anything in its log folder.
TEST_F(EvidenceTest, KeepsFilesAndFoldersOnly) {
  attempt(1, true, 40);
  fs::create_symlink("log", place(1) / "link");
  fs::create_directory_symlink("/", place(1) / "folder");
  fs::create_symlink("nothing", place(1) / "dangling");
  fakes::make_pipe(place(1) / "pipe");
  fakes::make_socket(place(1) / "socket");
  remove_odd(place(1));
  std::vector<std::string> left;
  for (const auto& entry : fs::directory_iterator(place(1))) left.push_back(entry.path().filename());
  EXPECT_THAT(left, ElementsAre("log"));
  EXPECT_TRUE(fs::exists("/tmp"));
  remove_odd(place(2));
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

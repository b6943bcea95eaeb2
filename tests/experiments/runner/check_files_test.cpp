#include "experiments/runner/check_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "experiments/runner/evidence.h"
#include "tests/experiments/runner/support.h"

namespace runner {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class CheckFiles : public testing::Test {
 protected:
  void SetUp() override {
    for (int pair : {0, 1}) {
      fs::create_directories(place(pair));
      std::ofstream(place(pair) / "game.replies") << "some replies of pair " << pair;
      std::ofstream(place(pair) / "worker.log") << "said";
    }
    std::ofstream(root() / "manifest.json") << "{}";
    known_ = files_in(root(), place(0));
    record::Attempt attempt;
    attempt.key = {"equal", 0, 0};
    attempts_.push_back(attempt);
  }
  fs::path root() const { return folder_.path(); }
  fs::path place(int pair) const { return root() / "games" / record::game_id({"equal", pair, 0}) / "1"; }
  FileCheck check() const { return check_files(root(), known_, attempts_); }

  TemporaryFolder folder_;
  std::vector<record::KeptFile> known_;
  std::vector<record::Attempt> attempts_;
};

TEST_F(CheckFiles, FilesOfGamesThatAreNotInTheLedgerAreNoAlarm) {
  const FileCheck found = check();
  EXPECT_EQ(found.whole, 2U);
  EXPECT_EQ(found.unknown, 2U);
  EXPECT_THAT(found.problems, IsEmpty());
}

TEST_F(CheckFiles, MissingChangedAndAddedOnesAreTold) {
  fs::remove(place(0) / "worker.log");
  std::ofstream(place(0) / "more") << "x";
  std::ofstream(place(0) / "game.replies", std::ios::app) << "x";
  EXPECT_THAT(check().problems, ElementsAre(HasSubstr("game.replies has 23 bytes, it was written with 22"),
                                            HasSubstr("worker.log is missing"), HasSubstr("more was added")));
}

TEST_F(CheckFiles, LinksAreNoFilesOfAGame) {
  fs::rename(place(0) / "worker.log", root() / "elsewhere");
  fs::create_symlink(root() / "elsewhere", place(0) / "worker.log");
  fs::create_symlink("nothing", place(0) / "more");
  EXPECT_THAT(check().problems, ElementsAre(HasSubstr("worker.log is a link, a file was written"),
                                            HasSubstr("more was added")));
  fs::remove(place(0) / "worker.log");
  fs::create_directory(place(0) / "worker.log");
  EXPECT_THAT(check().problems, Contains(HasSubstr("worker.log is no file any more")));
}

TEST_F(CheckFiles, NamesThatLeadOutOfTheFolderAreTold) {
  known_.push_back({"/etc/passwd", 1, "x"});
  known_.push_back({"games/../../x", 1, "x"});
  EXPECT_THAT(check().problems, ElementsAre("/etc/passwd is a name outside of the folder",
                                            "games/../../x is a name outside of the folder"));
}

TEST_F(CheckFiles, EveryFlippedBitIsTold) {
  std::ifstream stream(place(0) / "game.replies");
  const std::string right((std::istreambuf_iterator<char>(stream)), {});
  for (std::size_t bit = 0; bit < 8 * right.size(); ++bit) {
    std::string wrong = right;
    wrong[bit / 8] = static_cast<char>(wrong[bit / 8] ^ (1 << (bit % 8)));
    std::ofstream(place(0) / "game.replies", std::ios::trunc) << wrong;
    EXPECT_THAT(check().problems, ElementsAre(HasSubstr("game.replies is not what was written")));
  }
}

}  // namespace
}  // namespace runner

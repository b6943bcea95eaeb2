#include "experiments/builds/builds.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <sstream>

#include "experiments/builds/git.h"
#include "experiments/process/family.h"
#include "tests/experiments/builds/repository.h"

namespace builds {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class BuildsTest : public testing::Test {
 protected:
  /// main against feature, in two conditions.
  schedule::Design design(
      const std::string& build = "mkdir -p bin && cp team.sh bin/team && echo x >> ../count") const {
    schedule::Design design;
    const record::TeamConfig team{.name = "team", .command = {"bin/team"}};
    schedule::Condition condition{"one", team, team};
    condition.a_source = schedule::Source{repository_.path(), "main", build};
    condition.b_source = schedule::Source{repository_.path(), "feature", build};
    design.conditions = {condition, condition};
    design.conditions[1].name = "two";
    return design;
  }

  std::vector<Build> prepare(schedule::Design& design) {
    std::ostringstream said;
    auto builds = builds::prepare(design, folder_, said);
    said_ = said.str();
    return builds;
  }

  std::string complaint(schedule::Design design) {
    try {
      prepare(design);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "accepted";
  }

  /// How many builds there were.
  int count() const {
    std::ifstream stream(folder_ / "count");
    int lines = 0;
    for (std::string line; std::getline(stream, line);) ++lines;
    return lines;
  }

  Repository repository_;
  fs::path folder_ = repository_.folder() / "results" / "builds";
  std::string said_;
};

TEST_F(BuildsTest, BuildsEachCommitOnceAndStartsTheTeamsThere) {
  schedule::Design both = design();
  const std::vector<Build> builds = prepare(both);
  ASSERT_EQ(builds.size(), 2U) << "not four: the conditions share them";
  EXPECT_EQ(count(), 2);
  EXPECT_TRUE(builds[0].made_now);
  EXPECT_EQ(builds[0].commit, commit_of(repository_.path(), "main", "a"));
  EXPECT_THAT(said_, HasSubstr("building main (commit " + builds[0].commit.substr(0, 12)));
  EXPECT_EQ(both.conditions[1].a.directory, builds[0].checkout);
  EXPECT_EQ(both.conditions[1].a_source->commit, builds[0].commit);
  EXPECT_EQ(listen_to({"bin/team"}, both.conditions[0].a.directory, std::chrono::seconds(10)).text, "one\n");
  EXPECT_EQ(listen_to({"bin/team"}, both.conditions[0].b.directory, std::chrono::seconds(10)).text, "two\n");
}

TEST_F(BuildsTest, FindsWhatWasBuiltBeforeAndStaysWithItWhenABranchMoves) {
  schedule::Design first = design();
  prepare(first);
  schedule::Design again = design();
  EXPECT_FALSE(prepare(again)[0].made_now);
  EXPECT_EQ(said_, "");
  EXPECT_EQ(again.conditions[0].a.directory, first.conditions[0].a.directory);

  repository_.write("echo three");
  repository_.shell("git add -A && " + repository_.identity + " commit -qm three");
  schedule::Design moved = design();
  prepare(moved);
  EXPECT_EQ(count(), 2) << "a run that continues must be the same experiment";
  EXPECT_EQ(moved.conditions[0].a.directory, first.conditions[0].a.directory);
  EXPECT_THAT(said_, HasSubstr("note: main has moved to "));

  folder_ = repository_.folder() / "elsewhere";
  prepare(moved);
  EXPECT_NE(moved.conditions[0].a.directory.filename(), first.conditions[0].a.directory.filename());
}

TEST_F(BuildsTest, AnotherBuildCommandIsAnotherBuild) {
  schedule::Design both = design();
  both.conditions[1].a_source->build += " && echo debug > flags";
  EXPECT_EQ(prepare(both).size(), 3U);
  EXPECT_NE(both.conditions[0].a.directory, both.conditions[1].a.directory);
}

TEST_F(BuildsTest, ABuildThatWasCutShortIsMadeAnew) {
  schedule::Design both = design();
  const Build built = prepare(both)[0];
  fs::remove(built.checkout.string() + ".built");
  std::ofstream(built.checkout / "half-made") << "x";
  schedule::Design again = design();
  EXPECT_TRUE(prepare(again)[0].made_now);
  EXPECT_FALSE(fs::exists(built.checkout / "half-made"));
}

TEST_F(BuildsTest, AFailedBuildIsOneSentenceWithTheEndOfItsLog) {
  const std::string text = complaint(design("echo compiling; echo 'team.cpp:7: error: no ball'; exit 3"));
  EXPECT_THAT(text, HasSubstr("condition 'one', team a: the build of main (commit "));
  EXPECT_THAT(
      text,
      HasSubstr("ended with code 3; it said last: compiling | team.cpp:7: error: no ball; all of it is in "));
  EXPECT_EQ(text.find('\n'), std::string::npos);
  EXPECT_THAT(complaint(design("echo 'team.cpp:7: error: no ball'; exit 3")), HasSubstr("no ball"))
      << "a failure is not taken for a build later";
}

TEST_F(BuildsTest, ABuildThatHangsIsEnded) {
  schedule::Design hanging = design("sleep 100");
  hanging.limits.build = 0.3;
  EXPECT_THAT(complaint(hanging), HasSubstr("took longer than 0 s (limits.build); it printed nothing"));
}

/// A build that never ends, with a child in its group and one in a session of its own.
const std::string endless =
    "sleep 300 & setsid sleep 300 & while ! [ -s ../two ]; do pgrep -x -P $$ sleep > ../begun; "
    "[ $(wc -l < ../begun) = 2 ] && cp ../begun ../two; sleep 0.02; done; wait";

TEST_F(BuildsTest, AnInterruptedBuildEndsWithAllThatItHasStarted) {
  schedule::Design both = design(endless);
  std::ostringstream said;
  int watching = 0;
  const Watch watch = [&] {
    ++watching;
    return [&]() -> std::optional<int> {
      if (fs::exists(folder_ / "two")) return SIGINT;
      return std::nullopt;
    };
  };
  try {
    builds::prepare(both, folder_, said, watch);
    FAIL() << "the build ended";
  } catch (const Interrupted& interrupted) {
    EXPECT_EQ(interrupted.signal, SIGINT);
  }
  EXPECT_EQ(watching, 1) << "not while git works, which must end at once";
  EXPECT_TRUE(fs::exists(folder_ / "two"));
  EXPECT_TRUE(process::started_with("MATCHDAY_BUILD=" + folder_.string()).empty());
}

TEST_F(BuildsTest, WhatAKilledProcessLeftOfABuildIsEndedBeforeItIsMadeAnew) {
  const pid_t child = ::fork();
  if (child == 0) {
    schedule::Design mine = design(endless);
    std::ostringstream nowhere;
    builds::prepare(mine, folder_, nowhere);
    ::_exit(0);
  }
  for (int i = 0; i < 1000 && !fs::exists(folder_ / "two"); ++i) ::usleep(10'000);
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  const auto left = [&] { return process::started_with("MATCHDAY_BUILD=" + folder_.string()); };
  EXPECT_FALSE(left().empty()) << "nobody could end them";
  schedule::Design again = design(endless);
  again.limits.build = 0.3;  // [s]
  EXPECT_THAT(complaint(again), HasSubstr("took longer"));
  EXPECT_TRUE(left().empty());
}

TEST_F(BuildsTest, TwoProcessesAtOnceBuildOnce) {
  const std::string slow = "sleep 0.3 && mkdir -p bin && cp team.sh bin/team && echo x >> ../count";
  const auto elsewhere = [&] {
    const pid_t child = ::fork();
    if (child == 0) {
      schedule::Design mine = design(slow);
      std::ostringstream nowhere;
      bool well = false;
      try {
        builds::prepare(mine, folder_, nowhere);
        well = fs::exists(mine.conditions[0].b.directory / "bin/team");
      } catch (const std::exception&) {
      }
      ::_exit(well ? 0 : 1);
    }
    return child;
  };
  const pid_t one = elsewhere();
  const pid_t other = elsewhere();
  for (const pid_t child : {one, other}) {
    int status = -1;
    ::waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
  }
  EXPECT_EQ(count(), 2);
}

TEST_F(BuildsTest, ARepositoryThatIsNotHereIsCopiedAndBroughtUpToDate) {
  schedule::Design remote = design();
  for (schedule::Condition& condition : remote.conditions) {
    condition.a_source->repository = "file://" + repository_.path().string();
    condition.b_source = std::nullopt;
  }
  schedule::Design again = remote;
  EXPECT_EQ(prepare(remote).size(), 1U);
  repository_.write("echo three");
  repository_.shell("git add -A && " + repository_.identity + " commit -qm three");
  prepare(again);
  EXPECT_EQ(listen_to({"bin/team"}, again.conditions[0].a.directory, std::chrono::seconds(10)).text, "one\n")
      << "the folder stays with its commits";
  again.conditions[0].a_source->revision = again.conditions[1].a_source->revision = "refs/heads/main";
  prepare(again);
  EXPECT_EQ(listen_to({"bin/team"}, again.conditions[0].a.directory, std::chrono::seconds(10)).text,
            "three\n");
}

TEST_F(BuildsTest, ADesignWithoutGitNeedsNoFolder) {
  schedule::Design plain;
  plain.conditions = {{"base", {.name = "a", .command = {"true"}}, {.name = "b", .command = {"true"}}}};
  EXPECT_TRUE(prepare(plain).empty());
  EXPECT_FALSE(fs::exists(folder_));
}

// The name of a commit becomes the name of a folder and an argument of git.
TEST_F(BuildsTest, RefusesACommitThatIsNone) {
  fs::create_directories(folder_);
  for (const std::string commit : {"../../somewhere", "--output=x", "abc", ""}) {
    std::ofstream(folder_ / "commits", std::ios::trunc)
        << commit << "\tmain\t" << repository_.path().string() << "\n";
    EXPECT_THAT(complaint(design()),
                HasSubstr("commits: '" + commit + "' is no commit: the file is damaged"));
  }
}

}  // namespace
}  // namespace builds

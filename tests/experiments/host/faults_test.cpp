// Every way in which a team can go wrong ends the game with the right party at fault,
// and leaves nothing behind.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "experiments/host/play.h"
#include "experiments/process/tree.h"
#include "tests/fakes/games.h"

namespace host {
namespace {

using namespace std::chrono_literals;
using record::Party;
using record::Termination;
using testing::AnyOf;
using testing::HasSubstr;

// Living processes that got this variable from us; /proc shows what a process started
// with, so never ourselves.
int living_with(const std::string& variable) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    std::ifstream file(entry.path() / "environ");  // empty for a zombie
    std::string text;
    for (std::string piece; std::getline(file, piece, '\0');) {
      if (piece == variable) ++count;
    }
  }
  return count;
}

class Faults : public testing::Test {
 protected:
  Faults() {
    ::setenv("HOST_TEST", std::to_string(::getpid()).c_str(), 1);
    options_.connect_deadline = 10s;
    options_.reply_deadline = 10s;
    options_.stop_grace = 100ms;
  }
  ~Faults() override {
    EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG), -1) << "a child was not reaped";
    const std::string variable = "HOST_TEST=" + std::to_string(::getpid());
    for (int attempt = 0; attempt < 1000 && living_with(variable) > 0; ++attempt) ::usleep(5000);
    EXPECT_EQ(living_with(variable), 0) << "processes were left behind";
  }

  record::MatchRecord play_against(const std::string& blue_mode) {
    return play(fakes::short_game("good", blue_mode), options_);
  }
  static void expect_blue(const record::MatchRecord& record, Termination termination,
                          const std::string& reason) {
    EXPECT_EQ(record::name(record.termination), std::string(record::name(termination)));
    EXPECT_EQ(record.at_fault, Party::Blue);
    EXPECT_THAT(record.reason, HasSubstr("blue (Fake B) " + reason));
    EXPECT_EQ(record::outcome(record), record::Outcome::YellowWins);
  }

  Options options_;
};

TEST_F(Faults, LastWordsAreQuoted) {
  expect_blue(
      play_against("last-words"), Termination::Crashed,
      R"(ended with code 3 before the game was over; it said last: "\"; yellow (Fake Y) crashed \\")");
}

TEST_F(Faults, ProgramThatDoesNotExist) {
  auto config = fakes::short_game("good", "good");
  config.teams.blue.command = {"/nowhere/team"};
  expect_blue(play(config, options_), Termination::NotStarted,
              "did not start: program '/nowhere/team' does not exist");
}

TEST_F(Faults, NeitherProgramExists) {
  auto config = fakes::short_game("good", "good");
  config.teams.yellow.command = {"/nowhere/a"};
  config.teams.blue.command = {"/nowhere/b"};
  const auto record = play(config, options_);
  EXPECT_EQ(record.termination, Termination::NotStarted);
  EXPECT_EQ(record.at_fault, Party::Both);
  EXPECT_THAT(record.reason, HasSubstr("'/nowhere/a' does not exist; blue"));
  EXPECT_EQ(record::outcome(record), record::Outcome::Void);
}

TEST_F(Faults, NeverConnects) {
  options_.connect_deadline = 1500ms;
  expect_blue(play_against("never-connect"), Termination::NotConnected, "did not connect within 1.5 s");
}

TEST_F(Faults, NeverSaysHello) {
  options_.connect_deadline = 1500ms;
  expect_blue(play_against("no-hello"), Termination::NotResponding, "did not answer within 1.5 s");
}

TEST_F(Faults, EndsAtStart) {
  expect_blue(play_against("exit-at-start"), Termination::Crashed, "ended with code 3 before it connected");
}

TEST_F(Faults, SpeaksAnOldVersion) {
  expect_blue(play_against("old-version"), Termination::Nonsense,
              "speaks protocol version 0, the host speaks 1");
}

TEST_F(Faults, NamesAKeeperItDoesNotHave) {
  expect_blue(play_against("bad-keeper"), Termination::Nonsense, "wants robot 15 as its keeper");
}

TEST_F(Faults, StopsAnswering) {
  options_.reply_deadline = 1s;
  const auto record = play_against("silent");
  expect_blue(record, Termination::NotResponding, "did not answer within 1 s");
  EXPECT_EQ(record.ticks, 5);
}

TEST_F(Faults, IgnoresTerm) {
  options_.reply_deadline = 1s;
  expect_blue(play_against("ignore-term"), Termination::NotResponding, "did not answer within 1 s");
}

TEST_F(Faults, BothStopAnsweringInTheSameTick) {
  options_.reply_deadline = 1s;
  const auto record = play(fakes::short_game("silent", "silent"), options_);
  EXPECT_EQ(record.at_fault, Party::Both);
  EXPECT_EQ(record::outcome(record), record::Outcome::Void);
}

TEST_F(Faults, YellowIsToBlameWhenYellowIs) {
  const auto record = play(fakes::short_game("crash", "good"), options_);
  EXPECT_EQ(record.at_fault, Party::Yellow);
  EXPECT_EQ(record::outcome(record), record::Outcome::BlueWins);
}

TEST_F(Faults, Crashes) {
  const auto record = play_against("crash");
  expect_blue(record, Termination::Crashed,
              "was ended by signal 11 (Segmentation fault) before the game was over");
  EXPECT_EQ(record.ticks, 5);
}

TEST_F(Faults, CrashesWithChildrenThatLiveOn) {
  expect_blue(play_against("fork-children"), Termination::Crashed, "was ended by signal 11");
}

TEST_F(Faults, EndsQuietly) {
  expect_blue(play_against("exit"), Termination::Closed, "ended with code 0 before the game was over");
}

TEST_F(Faults, ClosesTheChannelAndLivesOn) {
  expect_blue(play_against("close"), Termination::Closed, "closed the channel before the game was over");
}

TEST_F(Faults, AnswersAnotherTick) {
  expect_blue(play_against("wrong-tick"), Termination::Nonsense, "answered tick 4 when tick 5 was sent");
}

TEST_F(Faults, SendsBytesThatAreNoMessage) {
  expect_blue(play_against("nonsense"), Termination::Nonsense, "sent 16 bytes that are not a TeamMessage");
}

TEST_F(Faults, SendsAHugeMessage) {
  expect_blue(play_against("huge"), Termination::Nonsense,
              "sent nonsense: frame of 2097152 bytes is longer than the 4096 allowed");
}

// Refused by its meaning where it is shorter than a frame may be, by the frame's length otherwise.
TEST_F(Faults, SendsMoreThanAReplyCanMean) {
  expect_blue(play_against("commands"), Termination::Nonsense,
              "sent 1000 robot commands in one reply, 16 are allowed");
  expect_blue(play_against("megabyte"), Termination::Nonsense,
              "sent nonsense: frame of 1000010 bytes is longer than the 4096 allowed");
  expect_blue(play_against("long-note"), Termination::Nonsense,
              "sent a note of 2000 bytes, 1024 are allowed");
}

TEST_F(Faults, HasANameThatNoTableCanHold) {
  expect_blue(play_against("long-name"), Termination::Nonsense, "gives a name of 101 bytes, 100 are allowed");
  expect_blue(play_against("megabyte-name"), Termination::Nonsense,
              "sent nonsense: frame of 1048501 bytes is longer than the 4096 allowed");
  expect_blue(play_against("escape-name"), Termination::Nonsense,
              "gives a name with characters that control something");
}

// Which of both is seen first is a matter of when the system gave the host its turn.
TEST_F(Faults, FloodsTheChannel) {
  for (const std::string mode : {"flood", "megabytes"}) {
    const auto record = play_against(mode);
    EXPECT_EQ(record.termination, Termination::Nonsense);
    EXPECT_EQ(record.at_fault, Party::Blue);
    EXPECT_THAT(record.reason, AnyOf(HasSubstr("answered tick 5 when tick 6 was sent"),
                                     HasSubstr("sent more than one answer")));
  }
}

// Each answer has the right number, and is there before the tick: seen in the first
// whole second at the latest.
TEST_F(Faults, AnswersTicksThatItHasNotSeen) {
  const auto record = play_against("ahead");
  expect_blue(record, Termination::Nonsense, "");
  EXPECT_LE(record.ticks, 60);
}

TEST_F(Faults, NotesAndUnknownFieldsAreNotRecorded) {
  const std::filesystem::path folder =
      std::filesystem::path(testing::TempDir()) / ("faults_notes_" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  auto config = fakes::short_game("wander", "notes");
  config.recording = folder / "game.replies";
  const auto record = play(config, options_);
  EXPECT_EQ(record.termination, Termination::Finished) << record.reason;
  // Six commands of a few speeds for each team, without the 2 KiB beside them.
  EXPECT_LT(std::filesystem::file_size(*config.recording), static_cast<std::uintmax_t>(record.ticks) * 600);
  auto again = config;
  again.recording.reset();
  again.continuation = record::Continuation{folder / "game.replies", std::nullopt};
  EXPECT_EQ(play(again, options_).hash, record.hash);
  std::filesystem::remove_all(folder);
}

TEST_F(Faults, AnswersATickFarAhead) {
  expect_blue(play_against("future-tick"), Termination::Nonsense,
              "answered tick 9223372036854775807 when tick 5 was sent");
}

TEST_F(Faults, AnswersTheNextTickBeforeItWasSent) {
  // Seen at once when both come together; else the early one is taken for the next tick's, and the next
  // tick's own one is then old.
  const auto record = play_against("two-answers");
  expect_blue(record, Termination::Nonsense, "");
  EXPECT_THAT(record.reason, AnyOf(HasSubstr("answered tick 6 when tick 7 was sent"),
                                   HasSubstr("sent more than one answer: ")));
}

TEST_F(Faults, AnswersWithAnEmptyMessage) {
  expect_blue(play_against("no-reply"), Termination::Nonsense, "did not answer tick 5 with a reply");
}

TEST_F(Faults, SendsALengthThatNeverEnds) {
  expect_blue(play_against("endless"), Termination::Nonsense, "sent nonsense: ");
}

TEST_F(Faults, SendsHalfOfAnAnswer) {
  options_.reply_deadline = 1s;
  expect_blue(play_against("cut"), Termination::NotResponding, "did not answer within 1 s");
}

TEST_F(Faults, EndsWhenItIsGreeted) {
  expect_blue(play_against("exit-at-hello"), Termination::Crashed,
              "ended with code 4 before the game was over");
}

TEST_F(Faults, CrashesInTheMiddleOfTheGame) {
  auto config = fakes::short_game("wander", "crash");
  config.teams.blue.command = fakes::fake_team("crash", 600);
  const auto record = play(config, options_);
  expect_blue(record, Termination::Crashed, "was ended by signal 11");
  EXPECT_EQ(record.ticks, 600);
}

TEST_F(Faults, WhatATeamDoesAfterTheGameIsNoFault) {
  for (const std::string mode : {"crash-at-end", "linger"}) {
    auto config = fakes::short_game("wander", mode);
    config.half_length = 1;
    const auto record = play(config, options_);
    EXPECT_EQ(record.termination, Termination::Finished) << mode << ": " << record.reason;
    EXPECT_EQ(record.at_fault, Party::Nobody) << mode;
  }
}

// The fixture looks for processes of ours when the game is over.
TEST_F(Faults, DaemonsInSessionsOfTheirOwnAreEnded) {
  auto config = fakes::short_game("wander", "daemons");
  config.half_length = 1;
  const auto record = play(config, options_);
  EXPECT_EQ(record.termination, Termination::Finished) << record.reason;
}

TEST_F(Faults, EatsMemory) {
  options_.memory_limit = std::int64_t{300} << 20;
  for (const std::string mode : {"memory", "burst"}) {
    const auto record = play_against(mode);
    expect_blue(record, Termination::OverLimit, "held ");
    EXPECT_THAT(record.reason, HasSubstr(" MiB of memory, 300 MiB are allowed")) << mode;
  }
}

// Of 1200; a machine has room for some ten thousand, and host and runner need it, too.
TEST_F(Faults, StartsThreadsWithoutEnd) {
  const auto record = play_against("threads");
  expect_blue(record, Termination::OverLimit, "has ");
  EXPECT_THAT(record.reason, HasSubstr(" processes and threads, 1000 are allowed"));
}

// Of 512 MiB; the fake itself takes a few.
TEST_F(Faults, HoldsMemoryInFilesThatAreNotMapped) {
  options_.memory_limit = std::int64_t{300} << 20;
  for (const std::string mode : {"hoard", "hoard-apart"}) {
    const auto record = play_against(mode);
    expect_blue(record, Termination::OverLimit, "held ");
    EXPECT_THAT(record.reason, HasSubstr(" MiB of memory, 300 MiB are allowed")) << mode;
  }
}

TEST_F(Faults, WritesGigabytes) {
  options_.output_limit = std::int64_t{256} << 20;  // of the gigabytes it would print
  auto config = fakes::short_game("good", "gigabytes");
  config.directory =
      std::filesystem::path(testing::TempDir()) / ("faults_gigabytes_" + std::to_string(::getpid()));
  expect_blue(play(config, options_), Termination::OverLimit, "printed more than 256 MiB");
  EXPECT_LT(std::filesystem::file_size(config.directory / "blue.log"), 5U << 20);
  std::filesystem::remove_all(config.directory);
}

// The design's limits.output; 64 KiB are for the sentence that says so.
TEST_F(Faults, KeepsOfTheOutputWhatItIsTold) {
  options_.output_limit = std::int64_t{64} << 20;
  options_.kept_output = std::size_t{1} << 20;
  auto config = fakes::short_game("good", "gigabytes");
  config.directory =
      std::filesystem::path(testing::TempDir()) / ("faults_kept_" + std::to_string(::getpid()));
  play(config, options_);
  EXPECT_GE(std::filesystem::file_size(config.directory / "blue.log"), 1U << 20);
  EXPECT_LT(std::filesystem::file_size(config.directory / "blue.log"), (1U << 20) + (64U << 10));
  std::filesystem::remove_all(config.directory);
}

TEST_F(Faults, FillsItsLogFolder) {
  auto config = fakes::short_game("good", "writes");
  config.directory =
      std::filesystem::temp_directory_path() / ("matchday-writes-" + std::to_string(::getpid()));
  options_.output_limit = std::int64_t{256} << 20;
  expect_blue(play(config, options_), Termination::OverLimit, "printed and wrote more than 256 MiB");
  process::remove_tree(config.directory);
  options_.output_limit = std::int64_t{1} << 30;
  config.teams.blue.command = fakes::fake_team("litters");
  expect_blue(play(config, options_), Termination::OverLimit,
              "left more than 10000 files, or folders deeper");
  process::remove_tree(config.directory);
  EXPECT_FALSE(std::filesystem::exists(config.directory));
}

TEST_F(Faults, TakesRoomOnTheDiskThatNoFileShows) {
  options_.output_limit = std::int64_t{256} << 20;  // of 512 MiB
  for (const std::string mode : {"unlink", "reserve"}) {
    auto config = fakes::short_game("good", mode);
    config.directory =
        std::filesystem::temp_directory_path() / ("matchday-" + mode + "-" + std::to_string(::getpid()));
    expect_blue(play(config, options_), Termination::OverLimit, "printed and wrote more than 256 MiB");
    process::remove_tree(config.directory);
  }
}

TEST_F(Faults, StrangeFilesOfATeamTroubleNobody) {
  auto config = fakes::short_game("good", "mess");
  config.directory = std::filesystem::temp_directory_path() / ("matchday-mess-" + std::to_string(::getpid()));
  const auto record = play(config, options_);
  EXPECT_EQ(record.termination, Termination::Finished) << record.reason;
  EXPECT_TRUE(std::filesystem::exists(std::filesystem::symlink_status(config.directory / "blue" / "link")));
  EXPECT_FALSE(std::filesystem::exists(config.directory / "yellow")) << "it was empty";
  process::remove_tree(config.directory);
  EXPECT_FALSE(std::filesystem::exists(config.directory));
}

TEST_F(Faults, ATeamThatStandsStillForfeitsInAnExperiment) {
  auto config = fakes::short_game("wander", "good");
  config.half_length = 1;
  EXPECT_EQ(play(config, options_).termination, Termination::Finished) << "whoever looks on may judge";
  options_.must_be_plausible = true;
  expect_blue(play(config, options_), Termination::StoodStill, "never told a robot to move");
  config.teams.blue.command = fakes::fake_team("creep");
  expect_blue(play(config, options_), Termination::StoodStill,
              "did not move: no robot came further than 0.00 m");
}

TEST_F(Faults, WhereBothTeamsStandStillItIsNoGame) {
  auto config = fakes::short_game("good", "good");
  config.half_length = 1;
  options_.must_be_plausible = true;
  const auto record = play(config, options_);
  EXPECT_EQ(record.termination, Termination::Implausible);
  EXPECT_EQ(record.at_fault, Party::Harness);
  EXPECT_EQ(record.reason,
            "this was no game: yellow never told a robot to move, and blue never told a robot to move");
  EXPECT_EQ(record::outcome(record), record::Outcome::Void);
}

TEST_F(Faults, IsInterruptedByTheUser) {
  int asked = 0;
  options_.interrupted = [&asked] { return ++asked > 3; };
  const auto record = play_against("good");
  EXPECT_EQ(record.termination, Termination::Interrupted);
  EXPECT_EQ(record.at_fault, Party::Harness);
  EXPECT_EQ(record::outcome(record), record::Outcome::Void);
}

TEST_F(Faults, ALogThatCannotBeWrittenIsOurFault) {
  auto config = fakes::short_game("good", "good");
  config.log = "/proc/nowhere/game.log";
  const auto record = play(config, options_);
  EXPECT_EQ(record.termination, Termination::HarnessFault);
  EXPECT_EQ(record.at_fault, Party::Harness);
  EXPECT_THAT(record.reason, HasSubstr("/proc/nowhere"));
}

TEST_F(Faults, SlownessAndTalkAreNoFault) {
  auto config = fakes::short_game("chatter", "not-numbers");
  config.half_length = 1;
  config.directory =
      std::filesystem::path(testing::TempDir()) / ("faults_test_" + std::to_string(::getpid()));
  const auto record = play(config, options_);
  EXPECT_EQ(record.termination, Termination::Finished) << record.reason;
  EXPECT_GT(record.counters.at("bad_commands_blue"), 0);
  EXPECT_EQ(record.counters.at("bad_commands_yellow"), 0);
  // 20 kB a tick would be tens of MB: the log of its output stops at 4 MiB.
  EXPECT_LT(std::filesystem::file_size(config.directory / "yellow.log"), 5U << 20);
  EXPECT_GT(std::filesystem::file_size(config.directory / "yellow.log"), 4U << 20);
  std::filesystem::remove_all(config.directory);
}

}  // namespace
}  // namespace host

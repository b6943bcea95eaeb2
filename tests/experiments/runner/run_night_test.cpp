// What can go wrong in a night besides the games: the disk, the ledger, the programs, the clock, the user.

#include <SQLiteCpp/SQLiteCpp.h>
#include <fcntl.h>
#include <gmock/gmock.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/resource.h>

#include <algorithm>
#include <optional>
#include <set>

#include "experiments/process/family.h"
#include "experiments/record/checksum.h"
#include "experiments/runner/evidence.h"
#include "tests/experiments/runner/run_fixture.h"
#include "tests/fakes/programs.h"

namespace runner {
namespace {

using namespace std::chrono_literals;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class Night : public RunTest {
 protected:
  std::string status(const std::string& folder) const {
    std::ifstream stream(folder_.path() / folder / "status.json");
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  template <class Condition>
  static bool soon(Condition condition) {
    for (int i = 0; i < 2000; ++i) {  // 20 s, for a loaded machine; all of it needs milliseconds
      if (condition()) return true;
      std::this_thread::sleep_for(10ms);
    }
    return false;
  }

  bool playing(const std::string& folder) const {
    return soon([&] { return status(folder).find("\"kind\"") != std::string::npos; });
  }

  static int code_of(pid_t child) {
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  /// The table of an undisturbed run.
  std::vector<record::Attempt> expected() {
    play(options("undisturbed"));
    return table("undisturbed");
  }
};

// --- the user ------------------------------------------------------------------------------------

TEST_F(Night, FirstSignalLetsRunningGamesFinishAndStartsNone) {
  const pid_t child = play_elsewhere(options("a", {"--milliseconds", "3000"}));
  ASSERT_TRUE(playing("a"));
  ::kill(child, SIGTERM);
  EXPECT_EQ(code_of(child), 128 + SIGTERM);
  // Two places, so at most two games were running: a game lasts 3 s, the signal came during the first ones.
  EXPECT_EQ(table("a").size(), 2U);
  EXPECT_THAT(status("a"), HasSubstr("\"state\": \"interrupted\""));
  EXPECT_EQ(play(options("a")), Ending::Done);
  EXPECT_EQ(table("a"), expected());
}

TEST_F(Night, SecondSignalStopsAtOnce) {
  const pid_t child = play_elsewhere(options("a", {"--milliseconds", "100000"}));
  ASSERT_TRUE(playing("a"));
  ::kill(child, SIGINT);
  ASSERT_TRUE(soon([&] { return status("a").find("draining") != std::string::npos; }));
  ::kill(child, SIGINT);
  EXPECT_EQ(code_of(child), 128 + SIGINT);  // or the test takes 100 s
  EXPECT_TRUE(table("a").empty());
  EXPECT_EQ(left_over(), 0);
}

TEST_F(Night, AWorkerThatWasInterruptedByItselfIsAVoidGameThatIsPlayedAgain) {
  EXPECT_EQ(play(options("a", {"--fail", "first", "--how", "interrupted"})), Ending::Done);
  EXPECT_GT(table("a").size(), 16U);
}

TEST_F(Night, OneSignalEndsTheWaitingForRoomOnTheDisk) {
  RunOptions full = options("a");
  full.limits.free_disk = 500;
  int asked = 0;
  full.free_bytes = [&asked](const fs::path&) { return std::int64_t{++asked > 1 ? 100 : 1000} << 20; };
  full.housekeeping = 1ms;
  const pid_t child = play_elsewhere(full);
  ASSERT_TRUE(soon([&] { return status("a").find("waiting-for-disk") != std::string::npos; }));
  ::kill(child, SIGTERM);
  EXPECT_EQ(code_of(child), 128 + SIGTERM);  // or the test takes a quarter of an hour
  EXPECT_THAT(status("a"), HasSubstr("\"state\": \"interrupted\""));
  EXPECT_EQ(play(options("a")), Ending::Done);
  EXPECT_EQ(table("a"), expected());
}

TEST_F(Night, OneSignalEndsThePreflight) {
  RunOptions slow = options("a", {"--milliseconds", "100000"});
  slow.preflight = true;
  const pid_t child = play_elsewhere(slow);
  ASSERT_TRUE(soon([&] { return status("a").find("\"preflight\"") != std::string::npos; }));
  ::kill(child, SIGTERM);
  EXPECT_EQ(code_of(child), 128 + SIGTERM);
  EXPECT_TRUE(nobody_left());
}

TEST_F(Night, ASignalDuringTheLastReportEndsIt) {
  RunOptions reporting = options("a");
  reporting.refresh_command = {"sh", "-c", "touch " + (folder_.path() / "begun").string() + "; sleep 100"};
  const pid_t child = play_elsewhere(reporting);
  ASSERT_TRUE(soon([&] { return fs::exists(folder_.path() / "begun"); }));
  ::kill(child, SIGTERM);
  EXPECT_EQ(code_of(child), 128 + SIGTERM);  // or the test takes 100 s
  EXPECT_EQ(table("a").size(), 16U);
}

TEST_F(Night, FilesThatAreKeptAreInTheLedgerAsTheyAre) {
  RunOptions sampling = options("a", {"--fail", "first", "--how", "forfeit"});
  sampling.limits.sampled = 0.5;
  play(sampling);
  const fs::path root = folder_.path() / "a";
  std::vector<record::KeptFile> there = files_in(root, root / "games");
  ASSERT_FALSE(there.empty());
  there.push_back({"manifest.json", static_cast<std::int64_t>(fs::file_size(root / "manifest.json")),
                   record::checksum_of_file(root / "manifest.json")});
  EXPECT_EQ(record::Ledger::read(root / "ledger.sqlite").files(), there);
  sampling.limits.kept_logs = 0;
  sampling.limits.sampled = 1;
  design_.pairs = 5;
  sampling.grown_from = 4;
  play(sampling);
  EXPECT_FALSE(fs::exists(root / "games"));
  there = record::Ledger::read(root / "ledger.sqlite").files();
  ASSERT_EQ(there.size(), 1U) << "what is thrown away is forgotten";
  EXPECT_EQ(there[0].checksum, record::checksum_of_file(root / "manifest.json"));
}

// --- before the night ----------------------------------------------------------------------------

TEST_F(Night, PreflightFailsBeforeAnyGameIsPlayed) {
  RunOptions faulty = options("a", {"--fail", "always", "--how", "forfeit"});
  faulty.preflight = true;
  EXPECT_EQ(play(faulty), Ending::PreflightFailed);
  EXPECT_TRUE(table("a").empty());
  EXPECT_THAT(said_,
              HasSubstr("a short game before the first one failed: condition 'equal': yellow fell over"));
  EXPECT_TRUE(fs::exists(folder_.path() / "a/preflight/0/worker.log"));
}

TEST_F(Night, PreflightSaysOnceThatATeamIsNotDeterministicAndGoesOn) {
  RunOptions strange = options("a", {"--how", "differs"});
  strange.preflight = true;
  EXPECT_EQ(play(strange), Ending::Done);
  EXPECT_THAT(said_, HasSubstr("a team is not deterministic"));
  EXPECT_FALSE(fs::exists(folder_.path() / "a/preflight"));
  EXPECT_EQ(play(strange), Ending::Done);
  EXPECT_THAT(said_, Not(HasSubstr("deterministic"))) << "not again when a folder is continued";
}

// --- audits --------------------------------------------------------------------------------------

struct Strange {
  const char* how;
  record::Verdict verdict;
  const char* sentence;
};
class NightAudit : public Night, public testing::WithParamInterface<Strange> {};

TEST_P(NightAudit, SaysWhoIsNotDeterministic) {
  RunOptions audited = options("a", {"--how", GetParam().how});
  audited.limits.audited = 1;
  EXPECT_EQ(play(audited), Ending::Done);
  const auto audits = record::Ledger::read(folder_.path() / "a/ledger.sqlite").audits();
  ASSERT_EQ(audits.size(), 16U);
  for (const record::Audit& audit : audits) EXPECT_EQ(audit.verdict, GetParam().verdict);
  EXPECT_EQ(table("a").size(), 16U) << "an audit is no game of the schedule";
  EXPECT_THAT(said_, HasSubstr(GetParam().sentence));
  EXPECT_FALSE(fs::exists(folder_.path() / "a/audits"));
}

INSTANTIATE_TEST_SUITE_P(
    All, NightAudit,
    testing::Values(Strange{"good", record::Verdict::Same,
                            "16 games played again to compare hashes: the same"},
                    Strange{"differs", record::Verdict::TeamDiffers, "16 not, by a team that is not determ"},
                    Strange{"unstable", record::Verdict::SimulatorDiffers, "16 not, by the simulator"}),
    [](const auto& instance) { return std::string(instance.param.how); });

TEST_F(Night, AuditsThatWereMissedAreMadeWhenTheFolderIsContinued) {
  play(options("a"));
  RunOptions audited = options("a");
  audited.limits.audited = 1;
  EXPECT_EQ(play(audited), Ending::Done);
  EXPECT_EQ(record::Ledger::read(folder_.path() / "a/ledger.sqlite").audits().size(), 16U);
  EXPECT_EQ(table("a").size(), 16U);
}

// --- evidence ------------------------------------------------------------------------------------

TEST_F(Night, KeepsTheFilesOfSampledGames) {
  RunOptions sampling = options("a");
  sampling.limits.sampled = 0.5;
  play(sampling);
  std::size_t kept = 0;
  for (const record::Attempt& attempt : table("a")) {
    kept +=
        fs::exists(folder_.path() / "a/games" / record::game_id(attempt.key) / "1/game.replies.gz") ? 1 : 0;
  }
  EXPECT_GT(kept, 3U);  // 8 of 16 are expected, and the sample is the same in every run
  EXPECT_LT(kept, 13U);
}

TEST_F(Night, KeptFilesStayWithinTheirLimit) {
  RunOptions sampling = options("a");
  sampling.limits.sampled = 1;
  sampling.limits.kept_logs = 0;
  play(sampling);
  EXPECT_FALSE(fs::exists(folder_.path() / "a/games"));
  EXPECT_THAT(said_, HasSubstr("from now on the oldest go"));
}

// --- processes -----------------------------------------------------------------------------------

TEST_F(Night, EndsProcessesThatAGameLeftBehindInSessionsOfTheirOwn) {
  EXPECT_EQ(play(options("a", {"--how", "daemon"})), Ending::Done);
  EXPECT_EQ(process::started_with(game_variable + ("=" + folder_.path().string())).size(), 0U);
  EXPECT_THAT(said_, HasSubstr("1 process left behind, ended"));
  EXPECT_THAT(status("a"), HasSubstr("\"strays\": 16,"));
}

TEST_F(Night, EndsWhatAKilledRunLeftBehind) {
  const std::string mark = game_variable + ("=" + folder_.path().string());
  const pid_t child =
      play_elsewhere(options("a", {"--how", "daemon", "--fail", "always", "--milliseconds", "5"}));
  // A moment at which a daemon lives is short: kill at many until one was caught.
  std::this_thread::sleep_for(30ms);
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  // One more that surely is there, as a killed run leaves it.
  const pid_t orphan = ::fork();
  if (orphan == 0) {
    ::setsid();
    if (::fork() != 0) ::_exit(0);
    ::setenv(game_variable, (folder_.path().string() + "/a/games/equal-0000-0/1/").c_str(), 1);
    ::execlp("sleep", "sleep", "1000", nullptr);
    ::_exit(1);
  }
  ::waitpid(orphan, nullptr, 0);
  ASSERT_TRUE(soon([&] { return !process::started_with(mark).empty(); }));
  EXPECT_EQ(play(options("a")), Ending::Done);
  EXPECT_THAT(said_, HasSubstr("of an earlier run in this folder"));
  EXPECT_TRUE(process::started_with(mark).empty());
}

TEST_F(Night, LeavesNoTemporaryFilesNorOpenFilesBehind) {
  const std::size_t before = open_files();
  play(options("a"));
  EXPECT_EQ(open_files(), before);
  EXPECT_FALSE(fs::exists(folder_.path() / "a/scratch"));
}

TEST_F(Night, RemovesTheTemporaryFilesOfAKilledRun) {
  const pid_t child = play_elsewhere(options("a", {"--milliseconds", "5000"}));
  ASSERT_TRUE(playing("a"));
  std::string scratch;
  std::ifstream(folder_.path() / "a/scratch") >> scratch;
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  ASSERT_TRUE(fs::is_directory(scratch));
  play(options("a"));
  EXPECT_FALSE(fs::exists(scratch));
}

TEST_F(Night, AWorkerThatTakesTooMuchMemoryIsEnded) {
  // The limit itself is 4 GiB, which a test cannot take: the worker class is asked with a smaller one.
  WorkerLimits limits;
  limits.memory = std::int64_t{32} << 20;
  limits.grace = 50ms;
  Worker worker({fakes::bin_dir() + "/fake_worker", "--fail", "always", "--how", "eater"}, limits,
                Job{schedule::game(design_, 0), 1}, {.folder = folder_.path() / "eater"});
  std::optional<record::Attempt> attempt;
  ASSERT_TRUE(soon([&] { return (attempt = worker.poll()).has_value(); }));
  EXPECT_THAT(attempt->record.reason, HasSubstr("MiB of memory, 32 MiB are allowed"));
  EXPECT_EQ(attempt->record.at_fault, record::Party::Harness);
}

// --- the disk ------------------------------------------------------------------------------------

TEST_F(Night, DoesNotBeginOnAFullDisk) {
  RunOptions full = options("a");
  full.limits.free_disk = 500;
  full.free_bytes = [](const fs::path&) { return std::int64_t{100} << 20; };
  EXPECT_THAT(complaint(full), AllOf(HasSubstr("100 MiB left, 500 MiB are needed"), HasSubstr("make room")));
  EXPECT_TRUE(table("a").empty());
  EXPECT_THAT(status("a"), HasSubstr("storage-trouble"));
}

TEST_F(Night, WaitsForRoomWhileTheDiskIsFullAndGoesOn) {
  RunOptions full = options("a", {"--milliseconds", "20"});
  full.limits.free_disk = 500;
  int asked = 0;
  full.free_bytes = [&asked](const fs::path&) {
    ++asked;
    return asked > 2 && asked < 20 ? std::int64_t{100} << 20 : std::int64_t{1000} << 20;
  };
  EXPECT_EQ(play(full), Ending::Done);
  EXPECT_THAT(
      said_, AllOf(HasSubstr("no game is started until there is more"), HasSubstr("room on the disk again")));
  EXPECT_EQ(table("a"), expected());
}

TEST_F(Night, GivesUpWhenTheDiskStaysFullAndContinuesLater) {
  RunOptions full = options("a", {"--milliseconds", "20"});
  full.limits.free_disk = 500;
  full.disk_patience = 200ms;
  int asked = 0;
  full.free_bytes = [&asked](const fs::path&) { return std::int64_t{++asked > 3 ? 100 : 1000} << 20; };
  EXPECT_THAT(complaint(full), HasSubstr("make room and start again, nothing is lost"));
  EXPECT_EQ(play(options("a")), Ending::Done);
  EXPECT_EQ(table("a"), expected());
}

/// In a process of its own: a small disk that is really full, or may not be written. 77: not permitted here.
class NightDisk : public Night {
 protected:
  template <class Action>
  int on_small_disk(const char* size, Action action) {
    const fs::path disk = folder_.path() / "disk";
    fs::create_directories(disk);
    const pid_t child = ::fork();
    if (child == 0) {
      if (::unshare(CLONE_NEWNS) != 0 || ::mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0 ||
          ::mount("tmpfs", disk.c_str(), "tmpfs", 0, size) != 0) {
        ::_exit(77);
      }
      ::_exit(action(disk));
    }
    return code_of(child);
  }
};

TEST_F(NightDisk, FullInTheMiddleLosesNothing) {
  const std::vector<record::Attempt> right = expected();
  const int code = on_small_disk("size=512k", [&](const fs::path& disk) {
    RunOptions small = options("x");
    small.out = disk / "a";
    small.disk_patience = 300ms;
    // Leave some pages: enough to begin (36 KiB of ledger, its log and 32 KiB of shared memory beside it, the
    // manifest), not enough for the ledger and the games' files.
    const std::int64_t ballast = free_bytes(disk) - (std::int64_t{180} << 10);
    { std::ofstream(disk / "ballast") << std::string(static_cast<std::size_t>(ballast), 'x'); }
    std::string problem;
    Ending ending{};
    try {
      std::ostringstream said;
      ending = run(design_, small, said).ending;
    } catch (const record::StorageError& error) {
      problem = error.what();
    }
    std::cerr << problem << '\n';
    if (problem.find("ledger") == std::string::npos && ending != Ending::TooManyFaults) return 1;
    fs::remove(disk / "ballast");
    std::ostringstream said;
    if (run(design_, small, said).ending != Ending::Done) return 2;
    fs::copy_file(disk / "a/ledger.sqlite", folder_.path() / "undisturbed/other.sqlite");
    return 0;
  });
  if (code == 77) GTEST_SKIP() << "mounting a small disk is not permitted here";
  ASSERT_EQ(code, 0);
  fs::create_directories(folder_.path() / "b");
  fs::rename(folder_.path() / "undisturbed/other.sqlite", folder_.path() / "b/ledger.sqlite");
  EXPECT_EQ(counted(table("b")), counted(right));
}

TEST_F(NightDisk, ReadOnlyIsOneSentence) {
  const int code = on_small_disk("size=1m", [&](const fs::path& disk) {
    RunOptions small = options("x");
    small.out = disk / "a";
    std::ostringstream said;
    RunOptions unfinished = options("x", {"--fail", "always", "--how", "exit"});
    unfinished.out = small.out;
    unfinished.limits.faults_in_a_row = 2;
    run(design_, unfinished, said);
    if (::mount("tmpfs", disk.c_str(), nullptr, MS_REMOUNT | MS_RDONLY, nullptr) != 0) return 77;
    for (const char* folder : {"a", "b"}) {  // one that is there, one that is not
      small.out = disk / folder;
      try {
        run(design_, small, said);
        return 1;
      } catch (const record::StorageError& error) {
        const std::string sentence = error.what();
        std::cerr << sentence << '\n';
        if (sentence.find("read-only") == std::string::npos &&
            sentence.find("readonly") == std::string::npos &&
            sentence.find("Read-only") == std::string::npos) {
          return 2;
        }
      }
    }
    return 0;
  });
  if (code == 77) GTEST_SKIP() << "mounting a small disk is not permitted here";
  EXPECT_EQ(code, 0);
}

TEST_F(Night, AFileThatMayNotGrowEndsTheRunWithASentence) {
  const pid_t child = ::fork();
  if (child == 0) {
    const rlimit small{28'000, 28'000};  // [bytes]: an empty ledger has 24 KiB
    ::setrlimit(RLIMIT_FSIZE, &small);
    try {
      std::ostringstream said;
      run(design_, options("a"), said);
    } catch (const record::StorageError& error) {
      ::_exit(std::string(error.what()).find("ledger.sqlite") != std::string::npos ? 0 : 2);
    }
    ::_exit(1);
  }
  EXPECT_EQ(code_of(child), 0);
  EXPECT_EQ(play(options("a")), Ending::Done);
  EXPECT_EQ(table("a"), expected());
}

TEST_F(Night, AFileOfATeamThatIsLongerThanAnyDiskIsRemovedAndSaid) {
  EXPECT_EQ(play(options("a", {"--fail", "first", "--how", "sparse"})),
            Ending::Done);  // or the test takes hours
  EXPECT_THAT(said_,
              HasSubstr(": 1 file of 1048576 MiB in its folder was removed: a game keeps at most 2048 MiB"));
  const auto attempts = table("a");
  const auto faulty = std::find_if(attempts.begin(), attempts.end(), [](const auto& one) {
    return one.record.at_fault == record::Party::Yellow;
  });
  ASSERT_NE(faulty, attempts.end());
  EXPECT_THAT(faulty->record.reason, AllOf(HasSubstr("yellow fell over; 1 file of 1048576 MiB")));
}

// --- the ledger ----------------------------------------------------------------------------------

TEST_F(Night, ADamagedLedgerIsRefusedAndNotTouched) {
  play(options("a"));
  const fs::path ledger = folder_.path() / "a/ledger.sqlite";
  const auto size = fs::file_size(ledger);
  for (const std::string kind : {"garbage in the middle", "cut", "no ledger at all"}) {
    const fs::path copy = folder_.path() / kind / "ledger.sqlite";
    fs::create_directories(copy.parent_path());
    fs::copy_file(ledger, copy);
    if (kind == "cut") fs::resize_file(copy, size / 2);
    if (kind == "garbage in the middle") {
      std::fstream stream(copy, std::ios::in | std::ios::out | std::ios::binary);
      stream.seekp(4096);
      stream << std::string(size - 8192, '\x5a');
    }
    if (kind == "no ledger at all") std::ofstream(copy, std::ios::trunc) << std::string(8192, 'x');
    const auto hash = program_file(copy).hash;
    RunOptions again = options("a");
    again.out = copy.parent_path();
    EXPECT_THAT(complaint(again), AllOf(HasSubstr(copy.string()), HasSubstr("damaged"))) << kind;
    EXPECT_EQ(program_file(copy).hash, hash) << kind;
  }
}

TEST_F(Night, TwoRunsAtOnceDoNotMix) {
  std::vector<pid_t> runs;
  for (int i = 0; i < 5; ++i) {
    const pid_t child = ::fork();
    if (child == 0) {
      std::ostringstream said;
      try {
        run(design_, options("a", {"--milliseconds", "10"}), said);
      } catch (const record::StorageError& error) {
        ::_exit(std::string(error.what()).find("another run is writing there") != std::string::npos ? 5 : 1);
      }
      ::_exit(0);
    }
    runs.push_back(child);
  }
  std::multiset<int> codes;
  for (const pid_t one : runs) codes.insert(code_of(one));
  EXPECT_GE(codes.count(0), 1U);
  EXPECT_EQ(codes.count(0) + codes.count(5), 5U);
  EXPECT_EQ(table("a"), expected());
}

/// A ledger that another program uses, as somebody with sqlite3 does.
class NightLedger : public Night {
 protected:
  fs::path ledger(const std::string& folder) const { return folder_.path() / folder / "ledger.sqlite"; }
  SQLite::Database other(const std::string& folder) const {
    return SQLite::Database(ledger(folder).string(), SQLite::OPEN_READWRITE, 10'000);
  }
  /// Another program that holds it until it is killed. A process of its own: a fork of ours would inherit
  /// what SQLite knows of our locks.
  pid_t hold(const std::string& folder, const std::string& how) const {
    const fs::path held = folder_.path() / "held";
    fs::remove(held);
    const pid_t child = ::fork();
    if (child == 0) {
      SQLite::Database database = other(folder);
      database.exec(how);
      std::ofstream(held).close();
      for (;;) ::pause();
    }
    EXPECT_TRUE(soon([&] { return fs::exists(held); }));
    return child;
  }
  static void release(pid_t holder) {
    ::kill(holder, SIGKILL);
    ::waitpid(holder, nullptr, 0);
  }
  /// A run that ended early, so that there is a ledger with games.
  void begin(const std::string& folder) {
    const pid_t child = play_elsewhere(options(folder, {"--milliseconds", "50"}));
    ASSERT_TRUE(soon([&] { return status(folder).find("\"played\": 2") != std::string::npos; }));
    ::kill(child, SIGTERM);
    EXPECT_EQ(code_of(child), 128 + SIGTERM);
  }
};

TEST_F(NightLedger, SomebodyInTheMiddleOfAQueryIsNotWaitedFor) {
  begin("a");
  const std::size_t before = table("a").size();
  ASSERT_LT(before, 16U);
  SQLite::Database database = other("a");
  SQLite::Statement rows(database, "SELECT game FROM attempts");
  ASSERT_TRUE(rows.executeStep());  // and goes on with it when all games are played
  EXPECT_EQ(play(options("a")), Ending::Done);
  EXPECT_THAT(said_, Not(HasSubstr("another program")));
  std::size_t seen = 1;
  while (rows.executeStep()) ++seen;
  EXPECT_EQ(seen, before);
  EXPECT_EQ(table("a"), expected());
}

TEST_F(NightLedger, SomebodyWhoWritesIsWaitedForAndNoGameIsLost) {
  begin("a");
  SQLite::Database database = other("a");
  database.exec("BEGIN IMMEDIATE");
  std::thread release([&] {
    EXPECT_TRUE(soon([&] { return status("a").find("waiting-for-ledger") != std::string::npos; }));
    std::this_thread::sleep_for(300ms);
    EXPECT_LE(std::stoi(status("a").substr(status("a").find("\"played\": ") + 10)), 2)
        << "one for each place, then no game is started";
    database.exec("ROLLBACK");
  });
  RunOptions waiting = options("a", {"--milliseconds", "20"});
  EXPECT_EQ(play(waiting), Ending::Done);
  release.join();
  EXPECT_THAT(said_, AllOf(HasSubstr("another program holds the ledger"), HasSubstr("can be written again")));
  EXPECT_EQ(said_.find("no game is started"), said_.rfind("no game is started")) << "said once";
  EXPECT_EQ(table("a"), expected());
}

TEST_F(NightLedger, PatienceWithSomebodyWhoWritesComesToAnEnd) {
  begin("a");
  const std::size_t before = table("a").size();
  {
    SQLite::Database database = other("a");
    database.exec("BEGIN IMMEDIATE");
    RunOptions impatient = options("a");
    impatient.disk_patience = 300ms;
    EXPECT_THAT(complaint(impatient), AllOf(HasSubstr("another program holds"), HasSubstr("played again")));
    EXPECT_THAT(status("a"), HasSubstr("storage-trouble"));
  }
  EXPECT_EQ(table("a").size(), before);
  EXPECT_EQ(play(options("a")), Ending::Done);
  EXPECT_EQ(table("a"), expected());
}

TEST_F(NightLedger, OneSignalEndsTheWaitingForIt) {
  begin("a");
  const pid_t holder = hold("a", "BEGIN IMMEDIATE");
  const pid_t child = play_elsewhere(options("a"));
  ASSERT_TRUE(soon([&] { return status("a").find("waiting-for-ledger") != std::string::npos; }));
  ::kill(child, SIGTERM);
  EXPECT_EQ(code_of(child), 128 + SIGTERM);  // or the test takes a quarter of an hour
  release(holder);
  EXPECT_EQ(play(options("a")), Ending::Done);
  EXPECT_EQ(table("a"), expected());
}

TEST_F(NightLedger, OneThatIsHeldAsAWholeIsWaitedForBeforeTheFirstGame) {
  play(options("a"));
  for (const bool signalled : {true, false}) {
    const pid_t holder = hold("a", "BEGIN EXCLUSIVE");
    const pid_t child = play_elsewhere(options("a"));
    std::this_thread::sleep_for(500ms);
    EXPECT_EQ(::waitpid(child, nullptr, WNOHANG), 0) << "it waits";
    if (signalled) ::kill(child, SIGINT);
    if (!signalled) release(holder);
    EXPECT_EQ(code_of(child), signalled ? 128 + SIGINT : 0);
    if (signalled) release(holder);
  }
  EXPECT_EQ(table("a"), expected());
}

TEST_F(NightLedger, OnANetworkFileSystemItHasARollbackJournal) {
  begin("a");
  RunOptions remote = options("a", {"--milliseconds", "20"});
  remote.is_remote = [](const fs::path&) { return true; };
  remote.refresh_interval = 20ms;
  remote.refresh_command = {
      "sh", "-c", "ls " + (folder_.path() / "a").string() + " >> " + (folder_.path() / "seen").string()};
  EXPECT_EQ(play(remote), Ending::Done);
  EXPECT_THAT(said_, HasSubstr("network file system"));
  std::ifstream stream(folder_.path() / "seen");
  const std::string seen((std::istreambuf_iterator<char>(stream)), {});
  EXPECT_THAT(seen, AllOf(HasSubstr("ledger.sqlite"), Not(HasSubstr("-shm")), Not(HasSubstr("-wal"))));
  EXPECT_EQ(table("a"), expected());
}

TEST(NetworkFileSystems, AreToldFromOthers) {
  EXPECT_TRUE(is_remote_type(0x6969));       // NFS
  EXPECT_TRUE(is_remote_type(0xFF534D42));   // CIFS
  EXPECT_TRUE(is_remote_type(0x65735546));   // FUSE
  EXPECT_FALSE(is_remote_type(0xEF53));      // ext4
  EXPECT_FALSE(is_remote_type(0x9123683E));  // btrfs
  EXPECT_FALSE(is_remote_type(0x01021994));  // tmpfs
  EXPECT_FALSE(is_remote_type(0x794C7630));  // overlayfs
  EXPECT_FALSE(is_remote("/dev/shm"));
}

TEST_F(Night, AfterARunTheLedgerIsOneFile) {
  play(options("a"));
  EXPECT_FALSE(fs::exists(folder_.path() / "a/ledger.sqlite-wal"));
  EXPECT_FALSE(fs::exists(folder_.path() / "a/ledger.sqlite-shm"));
  SQLite::Database database((folder_.path() / "a/ledger.sqlite").string());
  EXPECT_EQ(database.execAndGet("PRAGMA journal_mode").getString(), "delete");
}

// --- programs and clocks -------------------------------------------------------------------------

class NightProgram : public Night {
 protected:
  NightProgram() {
    team_ = folder_.path() / "team";
    write_team("echo one\n");
    for (schedule::Condition& condition : design_.conditions) condition.b.command = {team_.string()};
  }
  void write_team(const std::string& script) const {
    const fs::path fresh = folder_.path() / "team.new";
    std::ofstream(fresh) << "#!/bin/sh\n" << script;
    fs::permissions(fresh, fs::perms::owner_all);
    fs::rename(fresh, team_);
  }
  fs::path team_;
};

TEST_F(NightProgram, ChangedBetweenTwoRunsIsAnotherExperiment) {
  play(options("a"));
  write_team("echo two\n");
  EXPECT_THAT(complaint(options("a")), AllOf(HasSubstr("holds experiment"), HasSubstr("give another --out")));
  write_team("echo one\n");
  EXPECT_EQ(play(options("a")), Ending::Done) << "restored, it is the same again";
}

TEST_F(NightProgram, ChangedDuringARunEndsItBeforeAnyGameCounts) {
  std::thread change([&] {
    playing("a");
    write_team("echo two\n");
  });
  const std::string said = complaint(options("a", {"--milliseconds", "200"}));
  change.join();
  EXPECT_THAT(said, AllOf(HasSubstr(team_.string()), HasSubstr("was changed while the experiment ran")));
  EXPECT_LT(table("a").size(), 16U);
  write_team("echo one\n");
  EXPECT_EQ(play(options("a")), Ending::Done);
  EXPECT_EQ(table("a").size(), 16U);
}

TEST_F(NightProgram, TouchedButNotChangedGoesOn) {
  std::thread touch([&] {
    playing("a");
    write_team("echo one\n");
  });
  EXPECT_EQ(play(options("a", {"--milliseconds", "50"})), Ending::Done);
  touch.join();
}

TEST_F(Night, AWallClockThatJumpsChangesNothing) {
  RunOptions jumping = options("a", {"--milliseconds", "20"});
  int asked = 0;
  jumping.date = [&asked] { return ++asked % 2 == 0 ? "1970-01-01T00:00:00Z" : "2038-01-19T03:14:08Z"; };
  EXPECT_EQ(play(jumping), Ending::Done);
  EXPECT_EQ(table("a"), expected());
}

// --- the report ----------------------------------------------------------------------------------

TEST_F(Night, RenewsTheReportWhileItRunsAndAtTheEnd) {
  RunOptions reporting = options("a", {"--milliseconds", "40"});
  reporting.refresh_interval = 50ms;
  reporting.refresh_command = {"sh", "-c", "echo x >> " + (folder_.path() / "renewed").string()};
  play(reporting);
  std::ifstream stream(folder_.path() / "renewed");
  const std::string text((std::istreambuf_iterator<char>(stream)), {});
  EXPECT_GE(text.size(), 4U);  // once at the end, and at least once in 0.3 s of games
  EXPECT_FALSE(fs::exists(folder_.path() / "a/refresh.log"));
}

TEST_F(Night, AReportThatFailsIsToldOnceAndEndsNothing) {
  RunOptions reporting = options("a", {"--milliseconds", "40"});
  reporting.refresh_interval = 50ms;
  reporting.refresh_command = {"sh", "-c", "echo no figures; exit 3"};
  EXPECT_EQ(play(reporting), Ending::Done);
  const std::string complaint = "the report could not be renewed: sh ended with code 3";
  ASSERT_THAT(said_, HasSubstr(complaint));
  EXPECT_EQ(said_.find(complaint), said_.rfind(complaint));
}

}  // namespace
}  // namespace runner

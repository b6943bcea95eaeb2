// What others do to a run's folder and programs while it runs.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <functional>

#include "experiments/runner/shortage.h"
#include "tests/experiments/runner/run_fixture.h"

namespace runner {
namespace {

using namespace std::chrono_literals;
using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;

class RunFolder : public RunTest {
 protected:
  fs::path at(const std::string& name) const { return folder_.path() / name; }

  /// Does something to a run in the middle; returns what the run dies of.
  std::string disturbed(const RunOptions& options, const std::function<void()>& action) {
    std::thread other([&] {
      for (int i = 0; i < 2000; ++i) {  // 20 s, for a loaded machine
        std::ifstream stream(options.out / "status.json");
        const std::string text((std::istreambuf_iterator<char>(stream)), {});
        if (text.find("\"kind\"") != std::string::npos) break;
        std::this_thread::sleep_for(10ms);
      }
      action();
    });
    const std::string said = complaint(options);
    other.join();
    return said;
  }
  RunOptions slow(const std::string& folder) const { return options(folder, {"--milliseconds", "300"}); }
};

/// The run may just be writing in there.
void remove_whole(const fs::path& folder) {
  std::error_code error;
  do {
    fs::remove_all(folder, error);
  } while (fs::exists(folder));
}

TEST_F(RunFolder, ThatIsRemovedEndsTheRun) {
  EXPECT_THAT(disturbed(slow("a"), [&] { remove_whole(at("a")); }),
              AllOf(HasSubstr("result folder " + at("a").string() + " was removed while the experiment ran"),
                    HasSubstr("its games are lost")));
}

TEST_F(RunFolder, ThatIsRenamedEndsTheRunAndTheGamesAreSaidToBeThere) {
  EXPECT_THAT(disturbed(slow("a"), [&] { fs::rename(at("a"), at("b")); }),
              HasSubstr("result folder " + at("a").string() +
                        " was renamed while the experiment ran: its games are in " + at("b").string() + ";"));
  std::ifstream stream(at("b") / "status.json");
  const std::string status((std::istreambuf_iterator<char>(stream)), {});
  EXPECT_THAT(status, AllOf(HasSubstr("storage-trouble"), HasSubstr("was renamed")));
  EXPECT_EQ(play(options("b")), Ending::Done);
  EXPECT_EQ(table("b").size(), 16U);
}

TEST_F(RunFolder, ThatIsExchangedForACopyEndsTheRun) {
  EXPECT_THAT(disturbed(slow("a"),
                        [&] {
                          fs::rename(at("a"), at("b"));
                          fs::copy(at("b"), at("a"), fs::copy_options::recursive);
                        }),
              AllOf(HasSubstr("and something else has its name: its games are in " + at("b").string())));
}

TEST_F(RunFolder, WhoseLedgerIsRemovedEndsTheRun) {
  for (const std::string ending : {"", "-wal"}) {
    EXPECT_THAT(
        disturbed(slow("a" + ending), [&] { fs::remove(at("a" + ending) / ("ledger.sqlite" + ending)); }),
        HasSubstr("ledger.sqlite" + ending + " was removed while the experiment ran"));
  }
}

TEST_F(RunFolder, WhoseLedgerIsRenamedEndsTheRun) {
  EXPECT_THAT(disturbed(slow("a"), [&] { fs::rename(at("a/ledger.sqlite"), at("a/old.sqlite")); }),
              HasSubstr("a/ledger.sqlite was renamed while the experiment ran: the games are in " +
                        at("a/old.sqlite").string()));
}

TEST_F(RunFolder, HasNoLinks) {
  RunOptions sampling = options("a");
  sampling.limits.sampled = 1;
  play(sampling);
  fs::create_directories(at("X/1"));
  std::ofstream(at("X/1/mine")) << "x";
  for (const std::string name :
       {"games", "games/equal-0001-0", "games/equal-0001-0/1", "scratch", "audits"}) {
    const fs::path link = at("a") / name;
    if (fs::exists(link)) fs::rename(link, at("kept"));
    fs::create_symlink(at("X"), link);
    EXPECT_THAT(complaint(sampling),
                HasSubstr(link.string() + ": is a link, and a run writes into its own folder only"));
    fs::remove(link);
    if (fs::exists(at("kept"))) fs::rename(at("kept"), link);
  }
  EXPECT_EQ(complaint(sampling), "none");
  design_.pairs = 8;
  sampling.grown_from = 4;
  sampling.worker_command.insert(sampling.worker_command.end(), {"--milliseconds", "300"});
  EXPECT_THAT(disturbed(sampling,
                        [&] {
                          fs::rename(at("a/games"), at("Y"));
                          fs::create_symlink(at("Y"), at("a/games"));
                        }),
              HasSubstr("a/games: is a link"))
      << "nor one that is made meanwhile";
  EXPECT_TRUE(fs::exists(at("X/1/mine")));
}

// --- programs --------------------------------------------------------------------------------------

class RunPrograms : public RunFolder {
 protected:
  RunPrograms() {
    fs::create_directories(at("programs"));
    write(at("programs/team"), "one");
    fs::create_directory_symlink("programs", at("link"));
    for (schedule::Condition& condition : design_.conditions) {
      condition.b.command = {at("link/team").string()};
    }
  }
  static void write(const fs::path& file, const std::string& text) {
    std::ofstream(file) << "#!/bin/sh\necho " << text << "\n";
    fs::permissions(file, fs::perms::owner_all);
  }
};

TEST_F(RunPrograms, SwappedForAMomentEndTheRunBeforeAnyGameCounts) {
  const fs::path team = at("programs/team");
  const fs::path kept = at("programs/kept");
  const std::map<std::string, std::function<void()>> swaps = {
      {"renamed",
       [&] {
         fs::rename(team, kept);
         write(team, "two");
         fs::rename(kept, team);
       }},
      {"written",
       [&] {
         write(team, "two");
         write(team, "one");
       }},
      {"link",
       [&] {
         fs::create_directories(at("other"));
         write(at("other/team"), "two");
         fs::remove(at("link"));
         fs::create_directory_symlink("other", at("link"));
         fs::remove(at("link"));
         fs::create_directory_symlink("programs", at("link"));
       }},
      {"folder",
       [&] {
         fs::rename(at("programs"), at("aside"));
         fs::create_directories(at("programs"));
         write(team, "two");
         fs::remove_all(at("programs"));
         fs::rename(at("aside"), at("programs"));
       }},
  };
  for (const auto& [how, swap] : swaps) {
    EXPECT_THAT(
        disturbed(slow(how), swap),
        AllOf(HasSubstr("link/team was changed while the experiment ran, though it is now as before")))
        << how;
    EXPECT_LT(table(how).size(), 16U) << how;
    EXPECT_EQ(play(options(how)), Ending::Done) << how;
    EXPECT_EQ(table(how).size(), 16U) << how;
  }
}

TEST_F(RunPrograms, BehindALinkThatLeadsElsewhereNowAreChanged) {
  fs::create_directories(at("other"));
  write(at("other/team"), "two");
  EXPECT_THAT(disturbed(slow("a"),
                        [&] {
                          fs::create_directory_symlink("other", at("new"));
                          fs::rename(at("new"), at("link"));
                        }),
              HasSubstr("games with the new one belong to another experiment"));
}

TEST_F(RunPrograms, MayHaveNewsBesideThem) {
  EXPECT_EQ(disturbed(slow("a"),
                      [&] {
                        write(at("programs/another"), "two");
                        ::utimensat(AT_FDCWD, at("programs/team").c_str(), nullptr, 0);  // as touch does
                        std::ofstream(at("programs/team"), std::ios::app).close();
                      }),
            "none");
}

// --- a machine that lacks something ----------------------------------------------------------------

TEST_F(RunFolder, AMachineWithoutOpenFilesIsWaitedFor) {
  const pid_t child = ::fork();
  if (child == 0) {
    RunOptions waiting = slow("a");
    waiting.first_pause = 20ms;
    const std::string complaint = disturbed(waiting, [] {
      rlimit before{};
      ::getrlimit(RLIMIT_NOFILE, &before);
      const rlimit none{3, before.rlim_max};
      ::setrlimit(RLIMIT_NOFILE, &none);
      std::this_thread::sleep_for(1s);  // 25 times as long as five void games in a row take
      ::setrlimit(RLIMIT_NOFILE, &before);
    });
    std::cerr << complaint << '\n' << said_;
    ::_exit(complaint == "none" && said_.find("the machine lacks processes") != std::string::npos ? 0 : 1);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
  const std::vector<record::Attempt> found = table("a");
  EXPECT_EQ(counted(found).size(), 16U);
  EXPECT_LE(found.size(), 20U) << "only what was running may be void";
}

TEST_F(RunFolder, AMachineWithoutOpenFilesIsNotWaitedForAllNight) {
  const pid_t child = ::fork();
  if (child == 0) {
    RunOptions impatient = slow("a");
    impatient.first_pause = 20ms;
    impatient.disk_patience = 300ms;
    const std::string complaint = disturbed(impatient, [] {
      rlimit none{};
      ::getrlimit(RLIMIT_NOFILE, &none);
      none.rlim_cur = 3;
      ::setrlimit(RLIMIT_NOFILE, &none);
    });
    std::cerr << complaint << '\n';
    ::_exit(complaint.find("s the machine has lacked processes") != std::string::npos ? 0 : 1);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
}

TEST(Shortage, WaitsLongerEachTimeUntilAGameGoesWell) {
  Shortage shortage(1s, 15min);
  const Shortage::Clock::time_point start{};
  EXPECT_FALSE(shortage.waiting(start));
  EXPECT_THAT(shortage.failed(start, "cannot fork").value_or(""),
              "cannot fork: the machine lacks processes, memory or open files; games are started again after "
              "a while");
  EXPECT_EQ(shortage.failed(start, "cannot fork"), std::nullopt) << "one of the same moment";
  EXPECT_TRUE(shortage.waiting(start + 999ms));
  EXPECT_FALSE(shortage.waiting(start + 1s));
  EXPECT_EQ(shortage.failed(start + 1s, "cannot fork"), std::nullopt) << "said once";
  EXPECT_TRUE(shortage.waiting(start + 2999ms));
  EXPECT_FALSE(shortage.waiting(start + 3s));
  EXPECT_EQ(shortage.too_long(start + 899s), std::nullopt);
  EXPECT_EQ(shortage.too_long(start + 900s),
            "cannot fork: for 900 s the machine has lacked processes, memory or open files");
  shortage.over();
  EXPECT_EQ(shortage.too_long(start + 900s), std::nullopt);
  EXPECT_TRUE(shortage.failed(start + 5s, "cannot fork"));
}

TEST(Shortage, IsToldFromOtherVoidGames) {
  record::MatchRecord record;
  record.termination = record::Termination::HarnessFault;
  record.reason = "program 'x': cannot fork: Resource temporarily unavailable";
  EXPECT_TRUE(is_shortage(record));
  record.reason = "the worker ended with code 3";
  EXPECT_FALSE(is_shortage(record));
  EXPECT_FALSE(is_shortage(std::runtime_error("x")));
  EXPECT_FALSE(is_shortage(process::StartError("x")));
  EXPECT_TRUE(is_shortage(process::StartError("x", ENOMEM)));
  EXPECT_TRUE(is_shortage(std::system_error(EMFILE, std::generic_category())));
}

}  // namespace
}  // namespace runner

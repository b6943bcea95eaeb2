#include "experiments/process/child.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <linux/keyctl.h>
#include <sched.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <fstream>
#include <iterator>
#include <thread>

#include "tests/fakes/process_group.h"

namespace process {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr auto patience = 20s;  // for a loaded machine; nothing here needs more than milliseconds

class ChildTest : public testing::Test {
 protected:
  ChildTest() {
    std::string folder = testing::TempDir() + "/child_test_XXXXXX";
    directory_ = ::mkdtemp(folder.data());
  }
  ~ChildTest() override { std::filesystem::remove_all(directory_); }

  Command shell(const std::string& script) const {
    Command command;
    command.arguments = {"sh", "-c", script};
    command.output = directory_ / "output";
    return command;
  }
  std::string output() const {
    std::ifstream file(directory_ / "output");
    return {std::istreambuf_iterator<char>(file), {}};
  }
  void wait_for_output(Child& child, const std::string& text) const {
    for (const auto end = Clock::now() + patience; output() != text && Clock::now() < end;) child.wait(5ms);
    ASSERT_EQ(output(), text);
  }

  std::filesystem::path directory_;
};

TEST_F(ChildTest, ReportsTheExitCode) {
  Child child(shell("exit 3"));
  ASSERT_TRUE(child.wait(patience));
  const Exit exit = child.stop(0ms);
  EXPECT_FALSE(exit.clean());
  EXPECT_EQ(exit.describe(), "ended with code 3");
}

/// How a start goes while the machine has no room for a process, for so long; in a process of its own, since
/// limits stay.
std::string start_without_room(std::chrono::milliseconds time) {
  const pid_t tester = ::fork();
  if (tester == 0) {
    // The limit does not hold for root; the number is that of nobody.
    if (::geteuid() == 0 && ::setresuid(65534, 65534, 65534) != 0) ::_exit(3);
    rlimit room{};
    ::getrlimit(RLIMIT_NPROC, &room);
    std::atomic<bool> none = false;
    std::thread([&] {
      none.wait(false);
      std::this_thread::sleep_for(time);
      ::setrlimit(RLIMIT_NPROC, &room);
    }).detach();
    const rlimit no_room{0, room.rlim_max};
    ::setrlimit(RLIMIT_NPROC, &no_room);
    none = true;
    none.notify_all();
    Command command;
    command.arguments = {"/bin/true"};
    int result = 3;
    try {
      Child child(command);
      result = child.wait(patience) ? 0 : 3;
    } catch (const MachineError&) {
      result = 1;
    } catch (const StartError&) {
      result = 2;
    }
    ::_exit(result);
  }
  int status = 0;
  ::waitpid(tester, &status, 0);
  constexpr std::array<const char*, 4> words = {"started", "the machine", "the program", "something else"};
  return WIFEXITED(status) ? words.at(static_cast<std::size_t>(WEXITSTATUS(status))) : "crashed";
}

// A program with threads without end is ended soon, but may take the room of others for a moment.
TEST(ChildWithoutRoom, IsStartedAsSoonAsThereIs) {
  EXPECT_EQ(start_without_room(200ms), "started");
  EXPECT_EQ(start_without_room(1h), "the machine") << "it is no fault of the program";
}

// What a program leaves in the keyring of a session, the next one would read.
TEST_F(ChildTest, HasNoKeysOfOursIfWanted) {
  if (::syscall(SYS_keyctl, KEYCTL_JOIN_SESSION_KEYRING, nullptr) < 0) GTEST_SKIP() << "no keys here";
  const std::string name = "matchday-test-" + std::to_string(::getpid());
  const long key = ::syscall(SYS_add_key, "user", name.c_str(), "x", 1UL, KEY_SPEC_SESSION_KEYRING);
  ASSERT_GE(key, 0);
  constexpr unsigned holders_only =
      0x3F000000;  // keyctl(2): all rights for who has it in a keyring, else none
  ASSERT_EQ(::syscall(SYS_keyctl, KEYCTL_SETPERM, key, holders_only), 0);
  for (const bool own : {false, true}) {
    Command command = shell("grep -c " + name + " /proc/keys");
    command.own_keys = own;
    Child child(command);
    ASSERT_TRUE(child.wait(patience));
    child.stop(0ms);
    EXPECT_EQ(output(), own ? "0\n" : "1\n");
  }
}

TEST_F(ChildTest, ReportsTheSignal) {
  Child child(shell("kill -SEGV $$"));
  ASSERT_TRUE(child.wait(patience));
  EXPECT_EQ(child.stop(0ms).describe(), "was ended by signal 11 (Segmentation fault)");
}

TEST_F(ChildTest, KeepsBothOutputsAndGivesNoInput) {
  Child child(shell("echo one; echo two >&2; cat; echo three"));
  ASSERT_TRUE(child.wait(patience));
  EXPECT_TRUE(child.stop(0ms).clean());
  EXPECT_EQ(output(), "one\ntwo\nthree\n");
}

TEST_F(ChildTest, PassesEnvironmentDirectoryAndArguments) {
  Command command;
  command.arguments = {"sh", "-c", "echo \"$MATCHDAY_TEST|$1|$HOME\"; pwd", "name",
                       "an argument with 'quotes'"};
  command.environment = {{"MATCHDAY_TEST", "a value"}, {"HOME", "/replaced"}};
  command.directory = directory_;
  command.output = directory_ / "output";
  Child child(command);
  ASSERT_TRUE(child.wait(patience));
  child.stop(0ms);
  EXPECT_EQ(output(), "a value|an argument with 'quotes'|/replaced\n" +
                          std::filesystem::canonical(directory_).string() + "\n");
}

TEST_F(ChildTest, RunsOnTheProcessorItWasGiven) {
  Command command = shell("grep Cpus_allowed_list /proc/self/status");
  cpu_set_t ours;
  ASSERT_EQ(::sched_getaffinity(0, sizeof ours, &ours), 0);
  command.cpu = 0;
  while (!CPU_ISSET(static_cast<std::size_t>(command.cpu), &ours)) ++command.cpu;
  Child child(command);
  ASSERT_TRUE(child.wait(patience));
  child.stop(0ms);
  EXPECT_EQ(output(), "Cpus_allowed_list:\t" + std::to_string(command.cpu) + "\n");
}

TEST_F(ChildTest, SaysWhyAProgramDoesNotStart) {
  Command missing;
  missing.arguments = {"no-such-team", "--fast"};
  EXPECT_THAT(
      [&] { Child child(missing); },
      testing::ThrowsMessage<StartError>(testing::StartsWith("program 'no-such-team' found neither in")));

  // Executable, but with an interpreter that does not exist.
  const std::filesystem::path script = directory_ / "script";
  std::ofstream(script) << "#!/nowhere/interpreter\n";
  std::filesystem::permissions(script, std::filesystem::perms::owner_all);
  Command broken;
  broken.arguments = {script.string()};
  EXPECT_THAT([&] { Child child(broken); },
              testing::ThrowsMessage<StartError>("program '" + script.string() +
                                                 "' cannot be executed: No such file or directory"));

  Command lost = shell("true");
  lost.directory = "/nowhere";
  EXPECT_THAT([&] { Child child(lost); },
              testing::ThrowsMessage<StartError>(
                  "program 'sh' cannot enter its working directory: No such file or directory"));
}

TEST_F(ChildTest, EndsPolitelyAChildThatObeys) {
  Child child(shell("trap 'echo bye; exit 0' TERM; echo ready; while :; do sleep 0.01; done"));
  wait_for_output(child, "ready\n");
  EXPECT_TRUE(child.stop(patience).clean());
  EXPECT_THAT(output(), testing::EndsWith("bye\n"));  // some shells also say that their sleep was terminated
}

TEST_F(ChildTest, KillsAChildThatIgnoresTerm) {
  Child child(shell("trap '' TERM; echo ready; while :; do sleep 0.01; done"));
  wait_for_output(child, "ready\n");
  const pid_t group = child.pid();
  const auto begin = Clock::now();
  const Exit exit = child.stop(50ms);
  EXPECT_GE(Clock::now() - begin, 50ms);
  EXPECT_TRUE(exit.signalled);
  EXPECT_EQ(exit.number, SIGKILL);
  EXPECT_TRUE(fakes::is_gone(group));
}

TEST_F(ChildTest, EndsTheChildrenOfTheChildAlsoWhenItHasLeftThemBehind) {
  Child child(shell("sleep 1000 & sleep 1000 & echo ready"));
  const pid_t group = child.pid();
  ASSERT_TRUE(child.wait(patience));
  EXPECT_TRUE(child.stop(0ms).clean());
  EXPECT_TRUE(fakes::is_gone(group));
}

TEST_F(ChildTest, LeavesNothingBehindWhenItGoesOutOfScope) {
  pid_t group = -1;
  {
    Child child(shell("sleep 1000 & echo ready; sleep 1000"));
    group = child.pid();
    wait_for_output(child, "ready\n");
    Child moved(std::move(child));
  }
  EXPECT_TRUE(fakes::is_gone(group));
}

TEST_F(ChildTest, IsNotBlockedByMoreOutputThanTheLogTakes) {
  Command command = shell("head -c 5000000 /dev/zero; echo >&2; exit 7");
  command.output_limit = 1000;
  Child child(command);
  ASSERT_TRUE(child.wait(patience));
  EXPECT_EQ(child.stop(0ms).number, 7);
  EXPECT_EQ(child.output().written(), 1000U);
  EXPECT_EQ(child.output().discarded(), 5000001U - 1000U);
  EXPECT_LT(std::filesystem::file_size(directory_ / "output"), 1100U);
}

TEST_F(ChildTest, InheritsNoFileAndNoIgnoredSignal) {
  constexpr int number = 50;  // one that no shell uses
  const int open_file = ::open("/dev/null", O_RDONLY);
  ASSERT_EQ(::dup2(open_file, number), number);  // without O_CLOEXEC
  ::signal(SIGPIPE, SIG_IGN);
  Child child(shell("if [ -e /proc/$$/fd/50 ]; then echo leaked; fi; grep SigIgn /proc/$$/status"));
  ASSERT_TRUE(child.wait(patience));
  child.stop(0ms);
  ::signal(SIGPIPE, SIG_DFL);
  ::close(number);
  ::close(open_file);
  EXPECT_EQ(output(), "SigIgn:\t0000000000000000\n");
}

TEST_F(ChildTest, DiesWithItsParent) {
  // A process between us and the child, ended as hard as can be.
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe(ends.data()), 0);
  const pid_t parent = ::fork();
  if (parent == 0) {
    Command command;
    command.arguments = {"sleep", "1000"};
    Child child(command);
    const pid_t number = child.pid();
    if (::write(ends[1], &number, sizeof number) < 0) ::_exit(1);
    while (true) ::pause();
  }
  pid_t group = -1;
  ASSERT_EQ(::read(ends[0], &group, sizeof group), static_cast<ssize_t>(sizeof group));
  ::kill(parent, SIGKILL);
  ::waitpid(parent, nullptr, 0);
  EXPECT_TRUE(fakes::is_gone(group));
  ::close(ends[0]);
  ::close(ends[1]);
}

TEST(Usage, CountsMemoryAndProcessorTime) {
  const auto ours = usage(::getpid());
  ASSERT_TRUE(ours);
  EXPECT_GT(ours->peak_memory, 1 << 20);  // any C++ program has more than a MiB
  EXPECT_GE(ours->user_seconds, 0);
  const pid_t gone = ::fork();
  if (gone == 0) ::_exit(0);
  ::waitpid(gone, nullptr, 0);
  EXPECT_FALSE(usage(gone));
}

}  // namespace
}  // namespace process

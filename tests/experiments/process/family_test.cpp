#include "experiments/process/family.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <functional>
#include <thread>
#include <vector>

#include "experiments/process/child.h"

namespace process {
namespace {

using namespace std::chrono_literals;

bool soon(const std::function<bool()>& condition) {
  for (int i = 0; i < 2000; ++i) {  // 20 s, for a loaded machine; all of it needs milliseconds
    if (condition()) return true;
    std::this_thread::sleep_for(10ms);
  }
  return false;
}

bool wants_processor(const Activity& activity) {
  return std::any_of(activity.threads.begin(), activity.threads.end(),
                     [](const Thread& thread) { return thread.wants_processor; });
}
/// Whoever runs.
bool all_by_choice(const Activity& activity) {
  return wants_processor(activity) &&
         std::all_of(activity.threads.begin(), activity.threads.end(),
                     [](const Thread& thread) { return thread.by_choice || !thread.wants_processor; });
}

class Family : public testing::Test {
 protected:
  /// A shell with our mark in its environment.
  Child shell(const std::string& script, const std::string& mark) const {
    Command command;
    command.arguments = {"sh", "-c", script};
    command.environment = {{"FAMILY_TEST", mark}};
    return Child(command);
  }
  std::string mark_ = std::to_string(::getpid()) + "/";
  std::string entry_ = "FAMILY_TEST=" + mark_;
};

TEST_F(Family, FindsProcessesByWhatTheyWereStartedWithInAnySession) {
  Child child = shell("setsid sleep 1000 & sleep 1000 & wait", mark_ + "a/");
  const auto leads_a_session = [](pid_t process) { return ::getsid(process) == process; };
  ASSERT_TRUE(soon([&] {
    const std::vector<pid_t> found = started_with(entry_ + "a/");
    return found.size() == 3 && std::any_of(found.begin(), found.end(), leads_a_session);
  }));
  EXPECT_TRUE(started_with(entry_ + "b/").empty());
  child.stop(0ms);
  ASSERT_TRUE(soon([&] { return started_with(entry_ + "a/").size() == 1; })) << "the group does not reach it";
  EXPECT_EQ(end_started_with(entry_ + "a/"), 1U);
  EXPECT_TRUE(started_with(entry_ + "a/").empty());
}

TEST_F(Family, SeesWhoSleepsAndWhoWantsAProcessor) {
  const Child sleeper = shell("sleep 1000", mark_);
  ASSERT_TRUE(soon([&] { return !wants_processor(family_activity(sleeper.pid())); }));
  Child worker = shell("(while :; do :; done) & wait", mark_);  // its child works, itself it sleeps
  ASSERT_TRUE(soon([&] { return wants_processor(family_activity(worker.pid())); }));
  const double before = family_activity(worker.pid()).processor_seconds;
  EXPECT_TRUE(soon([&] { return family_activity(worker.pid()).processor_seconds > before + 0.05; }));
  EXPECT_LT(family_activity(sleeper.pid()).processor_seconds, 1);
  worker.stop(0ms);
  EXPECT_FALSE(wants_processor(family_activity(worker.pid()))) << "there is no such process any more";
}

// What a child has used that has ended is its parent's: some 0.3 s for the loop.
TEST_F(Family, CountsTheProcessorTimeOfChildrenThatHaveEnded) {
  Child parent = shell("sh -c 'i=0; while [ $i -lt 300000 ]; do i=$((i+1)); done'; exec sleep 1000", mark_);
  EXPECT_TRUE(soon([&] {
    const Activity all = activity_of(family_of(parent.pid()));
    return all.processor_seconds - all.living_seconds > 0.05;
  }));
  parent.stop(0ms);
}

TEST_F(Family, KnowsHowLongSomebodyWaitedForAProcessor) {
  // Three that want the same one: each waits two thirds of the time.
  Child three = shell(
      "taskset -c $(taskset -cp $$ | sed 's/.*[^0-9]//') "
      "sh -c 'for i in 1 2 3; do (while :; do :; done) & done; wait'",
      mark_);
  ASSERT_TRUE(soon([&] { return family_activity(three.pid()).living_seconds > 0.3; }));
  const Activity all = family_activity(three.pid());
  EXPECT_TRUE(all.delays_known);
  double delays = 0;
  for (const Thread& thread : all.threads) delays += thread.delay_seconds;
  EXPECT_GT(delays, all.living_seconds) << "twice it, but for the last turns";
  EXPECT_NEAR(all.living_seconds, all.processor_seconds, 0.2)
      << "steps of 0.01 s of user and system time each";
  three.stop(0ms);
}

TEST_F(Family, SeesWhoHasChosenToWait) {
  const std::string loop = "sh -c 'while :; do :; done'";
  const std::string group = "/proc/self/autogroup";
  std::vector<std::string> scripts = {"exec nice " + loop, "exec chrt --idle 0 " + loop};
  if (std::thread::hardware_concurrency() > 1)
    scripts.push_back("exec taskset -c $(taskset -cp $$ | sed 's/.*[^0-9]//') " + loop);
  if (::access(group.c_str(), W_OK) == 0) {
    scripts.push_back("setsid sh -c 'echo 5 > " + group + "; while :; do :; done' & wait");
  }
  for (const std::string& script : scripts) {
    Child child = shell(script, mark_);
    EXPECT_TRUE(soon([&] { return all_by_choice(family_activity(child.pid())); })) << script;
    child.stop(0ms);
    end_started_with(entry_);
  }
  Child batch = shell("exec chrt --batch 0 " + loop, mark_);
  EXPECT_TRUE(soon([&] { return wants_processor(family_activity(batch.pid())); }));
  EXPECT_FALSE(all_by_choice(family_activity(batch.pid())));
  batch.stop(0ms);
}

// The state of a wait for the disk, as far as anybody can see.
TEST_F(Family, SeesUninterruptibleWaits) {
  const pid_t parent = ::fork();
  if (parent == 0) {
    if (::vfork() == 0) {
      ::sleep(1000);
      ::_exit(0);
    }
    ::_exit(0);
  }
  const auto waits = [](const Thread& thread) { return thread.uninterruptible && !thread.wants_processor; };
  EXPECT_TRUE(soon([&] {
    const std::vector<Thread> threads = activity_of(std::vector{parent}).threads;
    return std::any_of(threads.begin(), threads.end(), waits);
  }));
  for (const pid_t member : family_of(parent)) ::kill(member, SIGKILL);
  ::waitpid(parent, nullptr, 0);
}

TEST_F(Family, EndsOnlyThoseThatAreMeant) {
  Child meant = shell("exec sleep 1000", mark_ + "1/");
  Child other = shell("exec sleep 1000", mark_ + "11/");
  ASSERT_TRUE(soon([&] { return started_with(entry_).size() == 2; }));
  EXPECT_EQ(end_started_with(entry_ + "1/"), 1U);
  EXPECT_TRUE(meant.wait(20s));
  EXPECT_FALSE(other.has_ended());
  other.stop(0ms);
}

TEST_F(Family, EndsThoseThatGoOnStartingOthers) {
  // Each process starts the next one in a session of its own and ends; at most 200 of them,
  // for a test that fails.
  Child child = shell(
      "s='[ $2 -gt 0 ] || exit; sleep 0.05; setsid sh -c \"$1\" sh \"$1\" $(($2 - 1)) &'; "
      "setsid sh -c \"$s\" sh \"$s\" 200",
      mark_ + "chain/");
  ASSERT_TRUE(soon([&] { return !started_with(entry_ + "chain/").empty(); }));
  std::this_thread::sleep_for(120ms);
  child.stop(0ms);
  end_started_with(entry_ + "chain/");
  EXPECT_TRUE(started_with(entry_ + "chain/").empty());
}

TEST_F(Family, NobodyIsFoundWhereNobodyIs) { EXPECT_EQ(end_started_with(entry_ + "nobody/"), 0U); }

TEST_F(Family, AddsUpTheMemoryOfAllDescendants) {
  const std::int64_t own = resident_memory(::getpid());
  EXPECT_GT(own, 1 << 20);
  EXPECT_GE(family_memory(::getpid()), own);
  EXPECT_EQ(resident_memory(-1), 0);
  // Two shells deep a string of 32 MiB is made; the outer shells are small.
  Child child =
      shell("sh -c 'head -c 33554432 /dev/zero | tr \"\\\\0\" x | (x=$(cat); sleep 1000)'; true", mark_);
  EXPECT_TRUE(soon([&] { return family_memory(child.pid()) > std::int64_t{32} << 20; }));
  EXPECT_LT(resident_memory(child.pid()), 16 << 20);
  child.stop(0ms);
}

TEST_F(Family, CountsProcessesAndThreads) {
  // Three sleeps, and a process that has ended but is not waited for.
  Child child = shell("sleep 1000 & sleep 1000 & (exit) & exec sleep 1000", mark_);
  EXPECT_TRUE(soon([&] { return thread_count(family_of(child.pid())) == 4; }));
  child.stop(0ms);
  std::atomic<bool> over = false;
  const std::vector<pid_t> ours = {::getpid()};
  const std::size_t before = thread_count(ours);
  std::thread other([&over] { over.wait(false); });
  EXPECT_EQ(thread_count(ours), before + 1);
  over = true;
  over.notify_all();
  other.join();
  EXPECT_EQ(thread_count(std::vector<pid_t>{-1}), 0U);
}

// In a process of its own: who adopts orphans adopts them from then on.
TEST_F(Family, AdoptsOrphansAndReapsThem) {
  const pid_t tester = ::fork();
  if (tester == 0) {
    adopt_orphans();
    Child held = shell("exec sleep 1000", mark_);
    Child parent = shell("setsid sleep 1000 & setsid true & exit 0", mark_);
    parent.wait(20s);
    const std::vector<pid_t> known = {held.pid(), parent.pid()};
    if (!soon([&] { return children().size() == 4; })) ::_exit(1);  // both orphans have come
    std::size_t reaped = 0;
    if (!soon([&] { return (reaped += reap_adopted(known)) == 1; }))
      ::_exit(2);                            // `true` has ended by itself
    if (end_adopted(known) < 1) ::_exit(3);  // and `sleep` has not
    if (children().size() != 2) ::_exit(4);
    if (held.has_ended()) ::_exit(5);
    held.stop(0ms);
    parent.stop(0ms);
    ::_exit(children().empty() ? 0 : 6);
  }
  int status = 0;
  ::waitpid(tester, &status, 0);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 0);
}

}  // namespace
}  // namespace process

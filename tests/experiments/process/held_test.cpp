#include "experiments/process/held.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/mount.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <string>
#include <thread>

#include "experiments/process/family.h"
#include "experiments/process/tree.h"

namespace process {
namespace {

constexpr std::int64_t much = 8 << 20;  // [bytes]

/// A process that does something, says so and then waits for its end.
class Doing {
 public:
  /// @param what  gets the file in which one byte says that it is ready, unless it returns
  explicit Doing(const std::function<void(int)>& what) {
    std::array<int, 2> ends{};
    EXPECT_EQ(::pipe(ends.data()), 0);
    pid_ = ::fork();
    if (pid_ == 0) {
      ::setpgid(0, 0);
      ::alarm(60);  // for a test that fails
      what(ends[1]);
      say_ready(ends[1]);
      while (true) ::pause();
    }
    ::close(ends[1]);
    char byte = 0;
    EXPECT_EQ(::read(ends[0], &byte, 1), 1);
    ::close(ends[0]);
  }
  Doing(const Doing&) = delete;
  Doing& operator=(const Doing&) = delete;
  ~Doing() {
    ::kill(-pid_, SIGKILL);
    ::waitpid(pid_, nullptr, 0);
  }
  static void say_ready(int file) {
    if (::write(file, "x", 1) != 1) ::_exit(1);
  }
  Held held(const std::filesystem::path& folder = {}) const {
    return held_by(family_of(pid_), folder, OwnMounts::Counted);
  }
  pid_t pid() const { return pid_; }

 private:
  pid_t pid_ = -1;
};

void fill(int file) {
  const std::string text(much, 'x');
  if (::write(file, text.data(), text.size()) != much) ::_exit(1);
}

TEST(HeldTest, WhoHoldsNothingHasNothing) {
  const Held held = Doing([](int) {}).held("/tmp");
  EXPECT_EQ(held.memory, 0);
  EXPECT_EQ(held.disk, 0);
  EXPECT_TRUE(held.whole);
  EXPECT_EQ(held_by(std::array<pid_t, 1>{-1}, "", OwnMounts::Counted).memory, 0);
}

TEST(HeldTest, AMemoryFileCountsOnceHoweverManyHaveItOpen) {
  const Doing one([](int) {
    const int file = ::memfd_create("held", 0);
    fill(file);
    if (::dup(file) >= 0 && ::fork() == 0) ::pause();
  });
  EXPECT_EQ(one.held().memory, much);
}

TEST(HeldTest, WhatIsMappedIsResidentAndDoesNotCountAgain) {
  const Doing one([](int) {
    const int file = ::memfd_create("held", 0);
    fill(file);
    const void* place = ::mmap(nullptr, much, PROT_READ, MAP_SHARED | MAP_POPULATE, file, 0);
    if (place == MAP_FAILED) ::_exit(1);
  });
  EXPECT_EQ(one.held().memory, 0);
  EXPECT_GE(resident_memory(one.pid()), much);
}

TEST(HeldTest, AThreadMayHaveFilesOfItsOwn) {
  const Doing one([](int) {
    const int file = ::memfd_create("held", 0);
    fill(file);
    std::atomic<bool> apart = false;
    std::thread([&apart] {
      ::unshare(CLONE_FILES);
      apart = true;
      ::pause();
    }).detach();
    while (!apart) std::this_thread::yield();
    ::close(file);
  });
  EXPECT_EQ(one.held().memory, much);
}

// Of a process whose first thread has ended /proc says that it has no memory.
TEST(HeldTest, AProcessMayGoOnWithoutItsFirstThread) {
  const Doing one([](int ready) {
    std::thread([ready] {
      for (std::int64_t size = 1; size > 0;) std::ifstream("/proc/self/statm") >> size;
      static const std::string text(much, 'x');
      fill(::memfd_create("held", 0));
      Doing::say_ready(ready);
      ::pause();
    }).detach();
    ::syscall(SYS_exit, 0);
  });
  EXPECT_EQ(one.held().memory, much);
  EXPECT_GE(resident_memory(one.pid()), much);
}

TEST(HeldTest, AFileWithoutANameCountsOnItsDiskOnly) {
  std::string folder = (std::filesystem::temp_directory_path() / "held-XXXXXX").string();
  ASSERT_NE(::mkdtemp(folder.data()), nullptr);
  const Doing one([&folder](int) {
    const std::string path = folder + "/file";
    const int file = ::open(path.c_str(), O_CREAT | O_WRONLY, 0600);
    fill(file);
    ::unlink(path.c_str());
    fill(::open((folder + "/named").c_str(), O_CREAT | O_WRONLY, 0600));
  });
  EXPECT_GE(one.held(folder).disk, much);
  EXPECT_LE(one.held(folder).disk, much + 65'536) << "and what the disk needs to know where it is";
  EXPECT_EQ(one.held(folder).memory, 0);
  EXPECT_EQ(one.held("/proc").disk, 0);
  remove_tree(folder);
}

TEST(HeldTest, AFileSystemOfItsOwnInMemoryCounts) {
  const Doing one([](int) {
    const std::string user = "0 " + std::to_string(::geteuid()) + " 1";
    const std::string group = "0 " + std::to_string(::getegid()) + " 1";
    if (::unshare(CLONE_NEWUSER | CLONE_NEWNS) != 0) return;
    std::ofstream("/proc/self/setgroups") << "deny";
    std::ofstream("/proc/self/uid_map") << user;
    std::ofstream("/proc/self/gid_map") << group;
    if (::mount("held", "/media", "tmpfs", 0, nullptr) != 0) return;
    const int file = ::open("/media/file", O_CREAT | O_WRONLY, 0600);
    fill(file);
    ::close(file);
  });
  if (::access(("/proc/" + std::to_string(one.pid()) + "/root/media/file").c_str(), F_OK) != 0) {
    GTEST_SKIP() << "mounting is not permitted here";
  }
  // The kernel counts the pages of a file system for each processor by itself, in batches of 32 or twice the
  // number of processors (percpu_counter), and takes some for its folder.
  const std::int64_t processors = ::sysconf(_SC_NPROCESSORS_CONF);
  const std::int64_t loose = std::max<std::int64_t>(32, 2 * processors) * processors * ::getpagesize();
  EXPECT_NEAR(static_cast<double>(one.held().memory), static_cast<double>(much),
              static_cast<double>(loose + 65'536));
  EXPECT_EQ(held_by(std::array<pid_t, 1>{one.pid()}, "", OwnMounts::Ignored).memory, 0);
}

TEST(HeldTest, TooManyOpenFilesAreNotLookedThrough) {
  const Doing one([](int) {
    for (int process = 0; process < 11; ++process) {
      if (::fork() != 0) continue;
      for (int file = 10; file < 1010; ++file) ::dup2(0, file);
      ::pause();
    }
  });
  bool whole = true;
  for (int i = 0; i < 1000 && whole; ++i) {  // 10 s, for a loaded machine
    whole = one.held().whole;
    std::this_thread::sleep_for(std::chrono::milliseconds{10});
  }
  EXPECT_FALSE(whole);
}

}  // namespace
}  // namespace process

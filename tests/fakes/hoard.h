#pragma once

#include <fcntl.h>
#include <sched.h>
#include <sys/mman.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <thread>

// Memory that is not resident, and room on the disk that no file shows.
namespace fakes {

/// Writes 64 MiB more into an open file, at most 512 MiB in all, for a test that fails.
inline void fill(int file) {
  static int times = 0;
  if (++times > 8) return;
  const std::string much(std::size_t{1} << 20, 'x');
  for (int i = 0; i < 64; ++i) {
    if (::write(file, much.data(), much.size()) < 0) throw std::runtime_error("cannot fill a file");
  }
}

/// A file in a folder, with a name or without.
inline int open_file(const std::string& folder, bool named) {
  const std::string path = folder + "/hoard-" + std::to_string(::getpid());
  const int file = ::open(path.c_str(), O_CREAT | O_WRONLY | O_APPEND, 0600);
  if (!named) ::unlink(path.c_str());
  return file;
}

/// One tick of a mode of fake-team.
inline void hoard(const std::string& mode, const std::string& logs) {
  if (mode == "hoard" || mode == "hoard-apart") {
    static const int file = ::memfd_create("hoard", 0);
    if (mode == "hoard") return fill(file);
    static std::atomic<bool> is_apart = false;
    static std::atomic<bool> is_full = false;
    if (is_full) return;
    std::thread([] {
      ::unshare(CLONE_FILES);
      is_apart = true;
      for (int i = 0; i < 8; ++i) fill(file);
      is_full = true;
      while (true) ::pause();
    }).detach();
    while (!is_apart) std::this_thread::yield();
    ::close(file);
    while (!is_full) std::this_thread::sleep_for(std::chrono::milliseconds{10});
  }
  if (mode == "hoard-tmp") {
    static int times = 0;
    if (++times > 3) return;  // the folder has room for 256 MiB
    const int file = open_file(std::getenv("TMPDIR"), true);
    fill(file);
    ::close(file);
  }
  if (mode == "unlink") {
    static const int file = open_file(logs, false);
    fill(file);
  }
  if (mode == "reserve") {
    static const int file = open_file(logs, true);
    static int times = 0;
    if (times < 8) ::fallocate(file, FALLOC_FL_KEEP_SIZE, std::int64_t{times++} << 26, 1 << 26);
  }
}

}  // namespace fakes

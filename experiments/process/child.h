#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "experiments/process/isolation.h"
#include "experiments/process/output_log.h"
#include "experiments/process/program.h"

namespace process {

/// What to start, and how.
struct Command {
  std::vector<std::string> arguments;  ///< the first names the program, see find_program()
  std::vector<std::pair<std::string, std::string>> environment;  ///< added to ours, or in place of ours
  std::filesystem::path directory;                               ///< to work in; empty: ours
  std::filesystem::path input{};                                 ///< file for standard input; empty: none
  bool errors_apart = false;                                     ///< standard error is thrown away
  std::filesystem::path output;                     ///< file for standard output and error; empty: none
  std::size_t output_limit = std::size_t{4} << 20;  ///< [bytes] of that file
  int cpu = -1;                                     ///< the only one to run on; -1: as we do
  bool expendable = false;                          ///< the first to go when the machine is out of memory
  bool own_keys = false;                            ///< it has none of the keys of our session (keyrings(7))
  std::optional<Cell> cell{};                       ///< what it sees; nothing: what we see
};

/// How a process ended, and what it used.
struct Exit {
  bool began = true;  ///< false: it could not be started in its cell, and the last printed line says why
  bool signalled = false;
  int number = 0;  ///< exit code, or the signal's number
  // Processor time [s] of it and the children it has waited for.
  double user_seconds = 0;
  double system_seconds = 0;

  bool clean() const { return !signalled && number == 0; }
  /// "ended with code 3", "was ended by signal 11 (Segmentation fault)"
  std::string describe() const;
};

/// Files in /proc of one process.
struct Usage {
  std::int64_t peak_memory = 0;  ///< [bytes] VmHWM
  double user_seconds = 0;       ///< [s] of processor time so far
  double system_seconds = 0;     ///< [s] the same, inside the kernel
};
/// Nothing when there is no such process any more.
std::optional<Usage> usage(pid_t process);
/// Of a process and all its descendants, those included that have ended and were waited for; of their memory
/// that of the largest.
std::optional<Usage> family_usage(pid_t process);

/// One child process with its own process group, ended with everything in that group at the
/// latest by the destructor.
///
/// The child dies with us (PR_SET_PDEATHSIG), reads what it is given on standard input,
/// inherits no other open file, and writes into a pipe that drain() copies to a log of limited size.
/// Only this child is ever waited for.
class Child {
 public:
  /// @throws StartError naming the program and the cause
  explicit Child(const Command& command);
  Child(Child&& other) noexcept;
  Child(const Child&) = delete;
  Child& operator=(Child&&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child();

  pid_t pid() const { return pid_; }

  /// Copies what the child has printed since to its log; never blocks. At most 1 MiB at a time.
  void drain();

  /// Whether it has ended by itself; does not block.
  bool has_ended() { return wait(std::chrono::milliseconds{0}); }

  /// Waits for it to end by itself, draining its output meanwhile.
  ///
  /// @return whether it has ended
  bool wait(std::chrono::milliseconds patience);

  /// Ends it: TERM to the group, then after `grace` KILL to the group, then reaps it. Also when it has ended
  /// by itself, for what it may have left in its group. Calling it again returns the same.
  Exit stop(std::chrono::milliseconds grace);

  const OutputLog& output() const { return log_; }

  /// What it has used so far, of a program in a cell with all its processes;
  /// the last that was known when it has ended.
  const Usage& usage();

 private:
  bool isolated() const { return status_fd_ >= 0; }
  void reap();
  void read_status(Exit& exit);

  OutputLog log_;
  pid_t pid_ = -1;
  int exit_fd_ = -1;    // pidfd, readable when the child has ended
  int output_fd_ = -1;  // our end of its standard output and error
  int status_fd_ = -1;  // of a program in a cell: how it ended, as bubblewrap says
  Usage used_;
  std::optional<Exit> exit_;
};

}  // namespace process

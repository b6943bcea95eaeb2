#include "experiments/process/child.h"

#include <fcntl.h>
#include <linux/keyctl.h>
#include <poll.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <string_view>
#include <system_error>
#include <thread>

#include "experiments/process/family.h"

namespace process {
namespace {

using Clock = std::chrono::steady_clock;

// KILL takes microseconds; a process that waits for a dead network disk must not hold us up (ours).
constexpr std::chrono::seconds cell_patience{2};
// For the machine to have room for a process again. Ours: who takes it all is ended within a second.
constexpr std::chrono::seconds room_patience{2};
constexpr int pipe_bytes = 1 << 20;                        // the most an ordinary user may ask for (pipe(7))
constexpr std::size_t drain_bytes = std::size_t{1} << 20;  // one pipe full, so that a flood cannot hold us

std::string error_text(int error) { return std::generic_category().message(error); }

// What the child could not do, sent through a pipe that a successful exec closes.
enum class Step : int { Group, ParentGone, Directory, Cpu, Output, Exec };
struct Failure {
  Step step{};
  int error = 0;
};

const char* describe(Step step) {
  switch (step) {
    case Step::Group:
      return "cannot make its process group";
    case Step::ParentGone:
      return "the host ended meanwhile";
    case Step::Directory:
      return "cannot enter its working directory";
    case Step::Cpu:
      return "cannot be bound to its processor";
    case Step::Output:
      return "cannot redirect its output";
    case Step::Exec:
      return "cannot be executed";
  }
  return "";
}

struct Pipe {
  int read_end = -1;
  int write_end = -1;

  Pipe() {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0)
      throw MachineError("cannot make a pipe: " + error_text(errno), errno);
    read_end = ends[0];
    write_end = ends[1];
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  ~Pipe() {
    close_end(read_end);
    close_end(write_end);
  }
  static void close_end(int& end) {
    if (end >= 0) ::close(end);
    end = -1;
  }
};

struct OpenFile {
  int file = -1;
  explicit OpenFile(int opened) : file(opened) {}
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  ~OpenFile() { ::close(file); }
};

std::vector<std::string> whole_environment(const Command& command) {
  std::vector<std::string> all;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string_view text = *entry;
    const std::string_view key = text.substr(0, text.find('='));
    const bool replaced = std::any_of(command.environment.begin(), command.environment.end(),
                                      [&](const auto& added) { return added.first == key; });
    if (!replaced) all.emplace_back(text);
  }
  for (const auto& [key, value] : command.environment) all.push_back(key + "=" + value);
  return all;
}

std::vector<char*> pointers(std::vector<std::string>& strings) {
  std::vector<char*> result;
  result.reserve(strings.size() + 1);
  for (std::string& string : strings) result.push_back(string.data());
  result.push_back(nullptr);
  return result;
}

// Everything the child needs, made before the fork: afterwards only async-signal-safe calls are allowed.
struct Prepared {
  const char* program = nullptr;
  char* const* arguments = nullptr;
  char* const* environment = nullptr;
  const char* directory = nullptr;  // null: stay
  const cpu_set_t* cpus = nullptr;  // null: as inherited
  bool expendable = false;
  bool own_keys = false;
  int kept = -1;  // a file that is passed on
  pid_t parent = -1;
  int input = -1;
  int output = -1;
  int errors = -1;
  int report = -1;
};

[[noreturn]] void give_up(const Prepared& prepared, Step step) {
  const Failure failure{step, errno};
  [[maybe_unused]] const ssize_t ignored = ::write(prepared.report, &failure, sizeof failure);
  ::_exit(127);
}

[[noreturn]] void become(const Prepared& prepared) {
  if (::setpgid(0, 0) != 0) give_up(prepared, Step::Group);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != prepared.parent) give_up(prepared, Step::ParentGone);  // it ended before the line above

  // Ignored signals would stay ignored in the new program, and so would a blocked mask.
  struct sigaction usual {};
  usual.sa_handler = SIG_DFL;
  for (int number = 1; number < NSIG; ++number) ::sigaction(number, &usual, nullptr);
  sigset_t none;
  ::sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);

  if (prepared.expendable) {  // everybody may raise their own score; where it cannot be done, it is not
    const int score = ::open("/proc/self/oom_score_adj", O_WRONLY | O_CLOEXEC);
    if (score >= 0) {
      [[maybe_unused]] const ssize_t ignored = ::write(score, "1000", 4);
      ::close(score);
    }
  }
  // What one program leaves in a session's keyring, all later ones read. A kernel without keys has none to read.
  if (prepared.own_keys) ::syscall(SYS_keyctl, KEYCTL_JOIN_SESSION_KEYRING, nullptr);
  if (prepared.directory != nullptr && ::chdir(prepared.directory) != 0) give_up(prepared, Step::Directory);
  if (prepared.cpus != nullptr && ::sched_setaffinity(0, sizeof(cpu_set_t), prepared.cpus) != 0) {
    give_up(prepared, Step::Cpu);
  }
  if (::dup2(prepared.input, STDIN_FILENO) < 0 || ::dup2(prepared.output, STDOUT_FILENO) < 0 ||
      ::dup2(prepared.errors, STDERR_FILENO) < 0) {
    give_up(prepared, Step::Output);
  }
  // Whatever else is open here is not the child's business, also what somebody opened without O_CLOEXEC.
  ::syscall(SYS_close_range, 3U, ~0U, 4U /* CLOSE_RANGE_CLOEXEC */);
  if (prepared.kept >= 0) ::fcntl(prepared.kept, F_SETFD, 0);
  ::execve(prepared.program, prepared.arguments, prepared.environment);
  give_up(prepared, Step::Exec);
}

pid_t forked() {
  const Clock::time_point until = Clock::now() + room_patience;
  while (true) {
    const pid_t child = ::fork();
    if (child >= 0 || errno != EAGAIN || Clock::now() > until) return child;
    std::this_thread::sleep_for(std::chrono::milliseconds{10});
  }
}

void add(const rusage& used, Exit& exit) {
  const auto seconds = [](const timeval& span) {
    return static_cast<double>(span.tv_sec) + static_cast<double>(span.tv_usec) * 1e-6;
  };
  exit.user_seconds += seconds(used.ru_utime);
  exit.system_seconds += seconds(used.ru_stime);
}

std::chrono::milliseconds left_until(Clock::time_point deadline) {
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now());
  return std::max(left, std::chrono::milliseconds{0});
}

}  // namespace

std::string Exit::describe() const {
  if (!signalled) return "ended with code " + std::to_string(number);
  const char* text = ::sigdescr_np(number);
  return "was ended by signal " + std::to_string(number) + " (" + (text != nullptr ? text : "unknown") + ")";
}

Child::Child(const Command& command) : log_(command.output, command.output_limit) {
  if (command.arguments.empty()) throw StartError("the command of a program is empty");
  std::string program = find_program(command.arguments.front(), command.directory).string();
  std::vector<std::string> arguments = command.arguments;
  std::optional<Pipe> status;
  if (command.cell && command.cell->level != Isolation::None) {
    status.emplace();
    arguments = isolated_command(*command.cell, status->write_end, program, arguments, command.directory);
    program = arguments.front();
    adopt_orphans();  // see read_status()
  }
  std::vector<std::string> environment = whole_environment(command);
  const std::vector<char*> argument_pointers = pointers(arguments);
  const std::vector<char*> environment_pointers = pointers(environment);
  const std::string directory = command.directory.string();
  cpu_set_t cpus;
  CPU_ZERO(&cpus);
  if (command.cpu >= 0) CPU_SET(static_cast<std::size_t>(command.cpu), &cpus);

  Pipe output;
  Pipe report;
  const auto opened = [](const char* path, int mode) {
    const int file = ::open(path, mode | O_CLOEXEC);
    if (file < 0) throw StartError("cannot open " + std::string(path) + ": " + error_text(errno), errno);
    return OpenFile(file);
  };
  const OpenFile input = opened(command.input.empty() ? "/dev/null" : command.input.c_str(), O_RDONLY);
  const OpenFile nowhere = opened("/dev/null", O_WRONLY);

  Prepared prepared;
  prepared.program = program.c_str();
  prepared.arguments = argument_pointers.data();
  prepared.environment = environment_pointers.data();
  prepared.directory = directory.empty() ? nullptr : directory.c_str();
  prepared.cpus = command.cpu >= 0 ? &cpus : nullptr;
  prepared.expendable = command.expendable;
  prepared.own_keys = command.own_keys;
  prepared.kept = status ? status->write_end : -1;
  prepared.parent = ::getpid();
  prepared.input = input.file;
  prepared.output = output.write_end;
  prepared.errors = command.errors_apart ? nowhere.file : output.write_end;
  prepared.report = report.write_end;

  pid_ = forked();
  if (pid_ == 0) become(prepared);
  const int fork_error = errno;
  if (pid_ < 0)
    throw MachineError("program '" + command.arguments.front() + "': cannot fork: " + error_text(fork_error),
                       fork_error);
  ::setpgid(pid_, pid_);  // whoever comes first; fails harmlessly after the exec

  Pipe::close_end(output.write_end);
  Pipe::close_end(report.write_end);
  Failure failure;
  ssize_t count = 0;
  do {
    count = ::read(report.read_end, &failure, sizeof failure);
  } while (count < 0 && errno == EINTR);
  if (count > 0) {
    ::waitpid(pid_, nullptr, 0);
    throw StartError("program '" + command.arguments.front() + "' " + describe(failure.step) + ": " +
                         error_text(failure.error),
                     failure.error);
  }

  exit_fd_ = static_cast<int>(::syscall(SYS_pidfd_open, pid_, 0U));
  if (exit_fd_ < 0) {
    const int error = errno;
    ::kill(-pid_, SIGKILL);
    ::waitpid(pid_, nullptr, 0);
    throw StartError("program '" + command.arguments.front() + "' cannot be watched: " + error_text(error),
                     error);
  }
  ::fcntl(output.read_end, F_SETFL, O_NONBLOCK);
  ::fcntl(output.read_end, F_SETPIPE_SZ, pipe_bytes);  // a wish; smaller works too
  output_fd_ = std::exchange(output.read_end, -1);
  if (status) {
    Pipe::close_end(status->write_end);
    status_fd_ = std::exchange(status->read_end, -1);
    ::fcntl(status_fd_, F_SETFL, O_NONBLOCK);
  }
}

Child::Child(Child&& other) noexcept
    : log_(std::move(other.log_)),
      pid_(std::exchange(other.pid_, -1)),
      exit_fd_(std::exchange(other.exit_fd_, -1)),
      output_fd_(std::exchange(other.output_fd_, -1)),
      status_fd_(std::exchange(other.status_fd_, -1)),
      used_(other.used_),
      exit_(std::exchange(other.exit_, std::nullopt)) {}

Child::~Child() {
  if (pid_ >= 0) stop(std::chrono::milliseconds{0});
}

void Child::drain() {
  std::array<char, 65536> buffer;
  std::size_t total = 0;
  while (output_fd_ >= 0 && total < drain_bytes) {
    const ssize_t count = ::read(output_fd_, buffer.data(), buffer.size());
    if (count > 0) {
      log_.write({buffer.data(), static_cast<std::size_t>(count)});
      total += static_cast<std::size_t>(count);
    } else if (count < 0 && errno == EINTR) {
      continue;
    } else if (count < 0 && errno == EAGAIN) {
      return;
    } else {
      ::close(output_fd_);
      output_fd_ = -1;
    }
  }
}

bool Child::wait(std::chrono::milliseconds patience) {
  if (exit_) return true;
  const Clock::time_point deadline = Clock::now() + patience;
  while (true) {
    drain();
    std::array<pollfd, 2> watched{{{exit_fd_, POLLIN, 0}, {output_fd_, POLLIN, 0}}};  // poll skips -1
    const int ready = ::poll(watched.data(), watched.size(), static_cast<int>(left_until(deadline).count()));
    if (ready > 0 && watched[0].revents != 0) return true;
    if (Clock::now() >= deadline) return false;
  }
}

void Child::reap() {
  int status = 0;
  rusage used{};
  while (::wait4(pid_, &status, 0, &used) < 0 && errno == EINTR) {
  }
  Exit exit;
  exit.signalled = WIFSIGNALED(status);
  exit.number = exit.signalled ? WTERMSIG(status) : WEXITSTATUS(status);
  add(used, exit);
  if (isolated()) read_status(exit);
  exit_ = exit;
}

// Bubblewrap ends with the program's code, or 128 and the number of its signal as a shell says it. Only when
// the program was executed does it report that.
void Child::read_status(Exit& exit) {
  std::array<char, 4096> buffer;
  const ssize_t count = ::read(status_fd_, buffer.data(), buffer.size());
  const std::string text(buffer.data(), count > 0 ? static_cast<std::size_t>(count) : 0);
  exit.began = exit.signalled || text.find("\"exit-code\"") != std::string::npos;
  if (!exit.signalled && exit.began && exit.number > 128 && exit.number < 128 + NSIG) {
    exit.signalled = true;
    exit.number -= 128;
  }
  // The first process of the cell is an orphan now and came to us; with it everything in the cell has ended.
  constexpr std::string_view key = "\"child-pid\": ";
  const std::size_t found = text.find(key);
  if (found == std::string::npos) return;
  const auto first = static_cast<pid_t>(std::strtol(text.c_str() + found + key.size(), nullptr, 10));
  rusage used{};
  for (const Clock::time_point until = Clock::now() + cell_patience; Clock::now() < until;) {
    const pid_t reaped = ::wait4(first, nullptr, WNOHANG, &used);
    if (reaped != 0) {
      if (reaped == first) add(used, exit);
      break;
    }
    std::this_thread::sleep_for(std::chrono::microseconds{200});
  }
  exit.user_seconds = std::max(exit.user_seconds, used_.user_seconds);
  exit.system_seconds = std::max(exit.system_seconds, used_.system_seconds);
}

const Usage& Child::usage() {
  if (exit_) return used_;
  if (const auto now = isolated() ? family_usage(pid_) : process::usage(pid_)) {
    used_.user_seconds = std::max(used_.user_seconds, now->user_seconds);
    used_.system_seconds = std::max(used_.system_seconds, now->system_seconds);
    used_.peak_memory = std::max(used_.peak_memory, now->peak_memory);
  }
  return used_;
}

Exit Child::stop(std::chrono::milliseconds grace) {
  if (exit_) return *exit_;
  if (!has_ended()) usage();
  if (grace.count() > 0 && !has_ended()) {
    // Bubblewrap itself would take it for its own, and everything away at once.
    if (isolated()) {
      signal_descendants(pid_, SIGTERM);
    } else {
      ::kill(-pid_, SIGTERM);
    }
    wait(grace);
  }
  // Until it is reaped its number cannot name another group, so this reaches what it left
  // behind and nobody else.
  ::kill(-pid_, SIGKILL);
  reap();
  drain();
  ::close(exit_fd_);
  exit_fd_ = -1;
  if (output_fd_ >= 0) ::close(output_fd_);
  output_fd_ = -1;
  if (status_fd_ >= 0) ::close(status_fd_);
  status_fd_ = -1;
  return *exit_;
}

}  // namespace process

#include "experiments/process/family.h"

#include <sched.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <fstream>
#include <iterator>
#include <optional>
#include <set>
#include <sstream>
#include <string_view>
#include <thread>

#include "experiments/process/proc.h"

namespace process {
namespace {

using Clock = std::chrono::steady_clock;

// KILL takes microseconds; a process in an uninterruptible wait (a dead network disk)
// must not hold a night up
constexpr std::chrono::seconds patience{2};
constexpr std::size_t most_members = 4096;  // of a family, so that a fork bomb cannot hold us either

/// Children of all its threads; nothing on a kernel without CONFIG_PROC_CHILDREN.
std::vector<pid_t> children_of(pid_t process) {
  std::vector<pid_t> children;
  const std::string tasks = folder_of(process) + "/task";
  for (const pid_t thread : numbers_in(tasks)) {
    std::ifstream stream(tasks + "/" + std::to_string(thread) + "/children");
    children.insert(children.end(), std::istream_iterator<pid_t>(stream), std::istream_iterator<pid_t>());
  }
  return children;
}

/// What /proc says of a process or a thread, proc(5).
struct Stat {
  char state = 0;
  double used = 0;      ///< [s] of processor time
  double children = 0;  ///< [s] the same of children that were waited for
  int nice = 0;
  int threads = 0;
  int policy = 0;  ///< SCHED_OTHER, ...
};
std::optional<Stat> read_stat(const std::string& folder) {
  std::ifstream stream(folder + "/stat");
  std::string text;
  std::getline(stream, text);
  const std::size_t name_end = text.rfind(')');  // the name may hold anything
  if (name_end == std::string::npos) return std::nullopt;
  std::istringstream fields(text.substr(name_end + 1));
  Stat stat;
  fields >> stat.state;
  std::string skipped;
  for (int field = 4; field < 14; ++field) fields >> skipped;
  std::array<double, 4> ticks{};  // user, system, and both of children
  for (double& one : ticks) fields >> one;
  fields >> skipped >> stat.nice >> stat.threads;
  for (int field = 21; field < 41; ++field) fields >> skipped;
  fields >> stat.policy;
  if (!fields) return std::nullopt;
  const auto a_second = static_cast<double>(::sysconf(_SC_CLK_TCK));
  stat.used = (ticks[0] + ticks[1]) / a_second;
  stat.children = (ticks[2] + ticks[3]) / a_second;
  return stat;
}

/// Time of a thread on and waiting for a processor.
struct Turns {
  double on = 0;       ///< [s]
  double waiting = 0;  ///< [s]
};
std::optional<Turns> read_turns(const std::string& folder) {
  std::ifstream stream(folder + "/schedstat");
  Turns turns;
  if (!(stream >> turns.on >> turns.waiting)) return std::nullopt;
  return Turns{1e-9 * turns.on, 1e-9 * turns.waiting};
}

/// The nice value of all processes of its session together; 0 on a kernel without CONFIG_SCHED_AUTOGROUP.
int autogroup_nice(const std::string& folder) {
  std::ifstream stream(folder + "/autogroup");  // "/autogroup-7 nice 0"
  std::string skipped;
  int nice = 0;
  stream >> skipped >> skipped >> nice;
  return stream ? nice : 0;
}

/// What decides when a thread gets a processor.
struct Claim {
  int nice = 0;
  int group_nice = 0;
  cpu_set_t processors{};
};
cpu_set_t processors_of(pid_t thread) {
  cpu_set_t set;
  CPU_ZERO(&set);
  ::sched_getaffinity(thread, sizeof set, &set);  // where it fails, more than 1024 or just ended: none
  return set;
}
Claim our_claim() { return {::getpriority(PRIO_PROCESS, 0), autogroup_nice("/proc/self"), processors_of(0)}; }
bool claims_less(const Stat& stat, int group_nice, pid_t thread, const Claim& ours) {
  if (stat.policy == SCHED_IDLE || stat.nice > ours.nice || group_nice > std::max(0, ours.group_nice))
    return true;
  const cpu_set_t processors = processors_of(thread);
  return !CPU_EQUAL(&processors, &ours.processors);
}

void add_thread(pid_t id, const std::string& folder, int group_nice, const Claim& ours, Activity& sum) {
  const std::optional<Stat> stat = read_stat(folder);
  if (!stat) return;  // it has just ended
  const std::optional<Turns> turns = read_turns(folder);
  sum.delays_known = sum.delays_known && turns;
  const double on = turns ? turns->on : 0;
  sum.living_seconds += on;
  sum.threads.push_back({.id = id,
                         .wants_processor = stat->state == 'R',
                         .uninterruptible = stat->state == 'D',
                         .by_choice = claims_less(*stat, group_nice, id, ours),
                         .on_seconds = on,
                         .delay_seconds = turns ? turns->waiting : 0});
}

/// KILL through a pidfd, so that it reaches nobody who has got the number meanwhile.
void end(pid_t process, const std::string& entry) {
  const int handle = static_cast<int>(::syscall(SYS_pidfd_open, process, 0U));
  if (handle < 0) return;
  if (was_started_with(process, entry)) ::syscall(SYS_pidfd_send_signal, handle, SIGKILL, nullptr, 0U);
  ::close(handle);
}

/// 0 when there is no such process any more.
pid_t parent_of(pid_t process) {
  std::ifstream stream(folder_of(process) + "/stat");
  std::string text;
  std::getline(stream, text);
  const std::size_t name_end = text.rfind(')');  // the name may hold anything
  if (name_end == std::string::npos) return 0;
  std::istringstream fields(text.substr(name_end + 1));
  std::string state;
  pid_t parent = 0;
  fields >> state >> parent;
  return parent;
}

}  // namespace

bool was_started_with(pid_t process, const std::string& entry) {
  std::ifstream stream(folder_of(process) + "/environ", std::ios::binary);  // empty for a dead process
  for (std::string line; std::getline(stream, line, '\0');) {
    if (line.starts_with(entry)) return true;
  }
  return false;
}

void adopt_orphans() { ::prctl(PR_SET_CHILD_SUBREAPER, 1UL); }

std::vector<pid_t> children() { return children_of(::getpid()); }

std::size_t reap_adopted(std::span<const pid_t> known) {
  std::size_t reaped = 0;
  for (const pid_t child : children()) {
    if (std::find(known.begin(), known.end(), child) != known.end()) continue;
    if (::waitpid(child, nullptr, WNOHANG) == child) ++reaped;
  }
  return reaped;
}

std::size_t end_adopted(std::span<const pid_t> known) {
  std::size_t ended = 0;
  // Whoever dies may leave us its own children; each round goes one generation further down.
  for (const Clock::time_point until = Clock::now() + patience; Clock::now() < until;) {
    bool anybody = false;
    for (const pid_t child : children()) {
      if (std::find(known.begin(), known.end(), child) != known.end()) continue;
      anybody = true;
      if (::waitpid(child, nullptr, WNOHANG) == child) continue;
      ::kill(child, SIGKILL);  // ours until it is reaped, so the number is its own
      ++ended;
      std::this_thread::sleep_for(std::chrono::milliseconds{1});
      ::waitpid(child, nullptr, WNOHANG);
    }
    if (!anybody) break;
  }
  return ended;
}

std::vector<pid_t> family_of(pid_t process) {
  std::vector<pid_t> members = {process};
  for (std::size_t i = 0; i < members.size() && i < most_members; ++i) {
    const std::vector<pid_t> children = children_of(members[i]);
    members.insert(members.end(), children.begin(), children.end());
  }
  return members;
}

std::int64_t resident_memory(pid_t process) {
  const auto resident_of = [](const std::string& folder) {
    std::ifstream stream(folder + "/statm");  // sizes in pages: whole, resident, ...
    std::int64_t whole = 0;
    std::int64_t resident = 0;
    stream >> whole >> resident;
    return stream ? resident * ::sysconf(_SC_PAGESIZE) : 0;
  };
  if (const std::int64_t resident = resident_of(folder_of(process)); resident > 0) return resident;
  // A first thread that has ended holds nothing, while the others go on.
  const std::string tasks = folder_of(process) + "/task";
  for (const pid_t thread : numbers_in(tasks)) {
    const std::int64_t resident = resident_of(tasks + "/" + std::to_string(thread));
    if (resident > 0) return resident;
  }
  return 0;
}

std::int64_t family_memory(pid_t process) {
  std::int64_t sum = 0;
  for (const pid_t member : family_of(process)) sum += resident_memory(member);
  return sum;
}

std::size_t thread_count(std::span<const pid_t> processes) {
  std::size_t sum = 0;
  for (const pid_t process : processes) {
    const std::optional<Stat> stat = read_stat(folder_of(process));
    if (stat) sum += static_cast<std::size_t>(std::max(stat->threads, 1));
  }
  return sum;
}

Activity activity_of(std::span<const pid_t> processes) {
  Activity sum;
  const Claim ours = our_claim();
  for (const pid_t process : processes) {
    // Of the process, not the sum of its threads: those that have ended are in it.
    const std::optional<Stat> stat = read_stat(folder_of(process));
    if (stat) sum.processor_seconds += stat->used + stat->children;
    const std::string tasks = folder_of(process) + "/task";
    const int group_nice = autogroup_nice(folder_of(process));
    for (const pid_t thread : numbers_in(tasks)) {
      add_thread(thread, tasks + "/" + std::to_string(thread), group_nice, ours, sum);
    }
  }
  return sum;
}

Activity family_activity(pid_t process) { return activity_of(family_of(process)); }

double own_delay() {
  const std::optional<Turns> turns = read_turns("/proc/thread-self");
  return turns ? turns->waiting : 0;
}

void signal_descendants(pid_t process, int signal) {
  for (const pid_t member : family_of(process)) {
    if (member == process) continue;
    const int handle = static_cast<int>(::syscall(SYS_pidfd_open, member, 0U));
    if (handle < 0) continue;
    // Looked up again, since the number may have been given to another meanwhile.
    if (descends_from(member, process)) ::syscall(SYS_pidfd_send_signal, handle, signal, nullptr, 0U);
    ::close(handle);
  }
}

bool descends_from(pid_t process, pid_t ancestor) {
  for (std::size_t generation = 0; process > 0 && generation < most_members; ++generation) {
    if (process == ancestor) return true;
    process = parent_of(process);
  }
  return false;
}

bool belongs_to(pid_t process, pid_t leader) {
  if (process <= 0 || leader <= 0) return false;
  return descends_from(process, leader) || ::getpgid(process) == leader || ::getsid(process) == leader;
}

std::vector<pid_t> started_with(const std::string& entry) {
  std::vector<pid_t> found;
  for (const pid_t process : numbers_in("/proc")) {
    if (process != ::getpid() && was_started_with(process, entry)) found.push_back(process);
  }
  return found;
}

std::size_t end_started_with(const std::string& entry) {
  std::set<pid_t> seen;
  int empty_looks = 0;
  for (const Clock::time_point until = Clock::now() + patience; Clock::now() < until;) {
    const std::vector<pid_t> found = started_with(entry);
    // Twice: one may have been replaced by its child between the list of numbers and the look at it, or be in
    // the middle of an exec, where it has no environment.
    empty_looks = found.empty() ? empty_looks + 1 : 0;
    if (empty_looks == 2) break;
    for (const pid_t process : found) end(process, entry);
    seen.insert(found.begin(), found.end());
    std::this_thread::sleep_for(std::chrono::milliseconds{found.empty() ? 5 : 1});
  }
  return seen.size();
}

}  // namespace process

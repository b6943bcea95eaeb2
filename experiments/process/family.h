#pragma once

#include <sys/types.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

// Processes that nobody holds as a Child: what our children have started, and what they left behind.
namespace process {

/// From now on orphans among our descendants become our children (PR_SET_CHILD_SUBREAPER), also those that
/// made a session of their own.
void adopt_orphans();

/// Our children, dead ones that were not reaped included.
std::vector<pid_t> children();

/// Reaps dead children of ours that nobody holds: adopted orphans.
///
/// @param known  children that are reaped by their owners
/// @return       how many there were
std::size_t reap_adopted(std::span<const pid_t> known);

/// Ends with KILL and reaps all children of ours that nobody holds; returns how many were alive.
std::size_t end_adopted(std::span<const pid_t> known);

/// Memory [bytes] a process holds (resident, shared pages included); 0 when there is no such process.
std::int64_t resident_memory(pid_t process);

/// The same of a process and all its descendants together; shared pages count in each of them.
std::int64_t family_memory(pid_t process);

/// Processes and their threads, as the kernel's limits count them: one that has ended and is not yet waited for
/// is one.
std::size_t thread_count(std::span<const pid_t> processes);

/// A process and its descendants, itself first.
std::vector<pid_t> family_of(pid_t process);

/// Sends a signal to all descendants of a process, not to itself.
void signal_descendants(pid_t process, int signal);

/// Whether a process is `ancestor` or descends from it by living parents.
bool descends_from(pid_t process, pid_t ancestor);

/// The same, or it has lost its parents but not left the process group or session that `leader` leads.
bool belongs_to(pid_t process, pid_t leader);

/// Whether it was started with an environment in which a line "NAME=VALUE" begins with `entry`.
bool was_started_with(pid_t process, const std::string& entry);

/// What a thread is doing, and has done so far.
struct Thread {
  pid_t id = 0;
  bool wants_processor = false;  ///< it runs, or would if it had one
  bool uninterruptible = false;  ///< it waits for a disk, a child of vfork or something else in the kernel
  bool by_choice = false;        ///< it runs with less priority, or on other processors, than we do
  double on_seconds = 0;         ///< [s] on a processor
  double delay_seconds = 0;      ///< [s] for which it wanted one and had none, without the wait it is in
};

/// What processes are doing, and have done so far.
struct Activity {
  double processor_seconds = 0;  ///< [s] used, also by threads and children that have ended, to 0.01 s
  double living_seconds = 0;     ///< [s] of that by the threads that live, to the nanosecond
  bool delays_known = true;      ///< the kernel counts times of threads (CONFIG_SCHED_INFO, as usual)
  std::vector<Thread> threads;   ///< that live
};
Activity activity_of(std::span<const pid_t> processes);
/// The same of a process and its descendants.
Activity family_activity(pid_t process);

/// For how long this thread wanted a processor and had none [s]; 0 where the kernel does not count it.
double own_delay();

/// Living processes, never this one, that were started with an environment in which a line "NAME=VALUE"
/// begins with `entry`. Whoever starts a program passes such a line on unless it takes it out on purpose.
std::vector<pid_t> started_with(const std::string& entry);

/// Ends all of them with KILL, also those they start meanwhile, within 2 s.
///
/// @return  how many were found
std::size_t end_started_with(const std::string& entry);

}  // namespace process

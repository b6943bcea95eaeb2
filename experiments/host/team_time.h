#pragma once

#include <chrono>
#include <map>

#include "experiments/process/family.h"

namespace host {

/// What a team has done with its time so far.
struct TeamTime {
  double processor_seconds = 0;  ///< [s] used, also by threads and children that have ended, to 0.01 s
  double living_seconds = 0;     ///< [s] of that by the threads that live, to the nanosecond
  double used_seconds = 0;       ///< [s] what is known of both, also of children that nobody waited for
  double delay_seconds = 0;      ///< [s] for which the machine has kept it waiting
  bool delays_known = true;      ///< the kernel counts the last two
  bool wants_machine = false;    ///< it is perhaps kept waiting now, too shortly to be in `delay_seconds`
};

/// Tells what of a team's time the machine owes it: only that for which a thread of it could run and had no
/// processor, or waited for the disk, is not the team's own.
///
/// What it uses is added up from look to look: processor time of children that nobody waits for (SIGCHLD
/// ignored) is in no sum of the kernel when they have ended.
///
/// Two looks at its threads say that. What a thread has waited for a processor is its delay in `schedstat`;
/// the wait it is in counts when it wanted one at both looks and has not run between them. Not owed is what a
/// team arranges: the wait of a thread that has lowered its own priority or chosen its processors, and more
/// than `disk` in a game of uninterruptible waits. No file of an ordinary user tells a wait for the disk from
/// the others (vfork, membarrier, userfaultfd), and a team can wait for the disk on purpose, too.
class TeamClock {
 public:
  using Clock = std::chrono::steady_clock;

  explicit TeamClock(std::chrono::milliseconds disk)
      : disk_left_(std::chrono::duration<double>(disk).count()) {}

  /// To be called every 0.1 s or so while the team is waited for, at least once a second otherwise.
  TeamTime read(Clock::time_point now, const process::Activity& team);

 private:
  struct Known {
    bool by_choice = false;
    bool wanted = false;  ///< a processor
    double on = 0;        ///< [s] on one
    double waiting = 0;   ///< [s] in a wait that is not over
    double waited = 0;    ///< [s] with that
  };
  double disk_left_;  ///< [s]
  Clock::time_point last_{};
  std::map<pid_t, Known> threads_;
  bool begun_ = false;
  double processor_ = 0;  ///< [s] at the last look
  double used_ = 0;       ///< [s]
  double delay_ = 0;      ///< [s]
};

}  // namespace host

#include "experiments/host/team_time.h"

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

namespace host {
namespace {

// Delays of threads that wait for each other in turn add up, those of threads that wait side by side do not,
// and the kernel does not say which. So many may be in a chain (ours); of a hundred that wake each other all
// the time the rest is the team's own.
constexpr std::size_t longest_chain = 4;
// Of a wait for the disk that was perhaps not there between two looks far apart (ours).
constexpr double longest_disk_step = 1;  // [s]
// Sums of processes are told in steps of 0.01 s: twice that may be their rounding.
constexpr double rounding = 0.02;  // [s]

}  // namespace

TeamTime TeamClock::read(Clock::time_point now, const process::Activity& team) {
  const double passed = std::chrono::duration<double>(now - last_).count();
  TeamTime time{.processor_seconds = team.processor_seconds,
                .living_seconds = team.living_seconds,
                .delays_known = team.delays_known};
  std::map<pid_t, Known> seen;
  std::vector<double> delays;
  bool disk = false;
  double grown = 0;  // processor time of the threads that live
  for (const process::Thread& thread : team.threads) {
    Known& known = seen[thread.id];
    known = {.by_choice = thread.by_choice,
             .wanted = thread.wants_processor,
             .on = thread.on_seconds,
             .waited = thread.delay_seconds};
    const auto before = threads_.find(thread.id);
    const bool has_lived = before != threads_.end() && thread.on_seconds >= before->second.on;
    grown += thread.on_seconds - (has_lived ? before->second.on : 0);
    if (thread.by_choice) continue;
    const bool is_new = !has_lived || before->second.by_choice;
    const bool has_run = !is_new && thread.on_seconds > before->second.on;
    if (known.wanted && !has_run) time.wants_machine = true;
    if (is_new) continue;
    if (known.wanted && before->second.wanted && !has_run) known.waiting = before->second.waiting + passed;
    known.waited += known.waiting;
    if (known.waited > before->second.waited) delays.push_back(known.waited - before->second.waited);
    disk = disk || thread.uninterruptible;
  }
  std::sort(delays.begin(), delays.end(), std::greater<>());
  if (delays.size() > longest_chain) delays.resize(longest_chain);
  double owed = 0;
  for (const double delay : delays) owed += delay;
  // A wait may have begun before the last look: it is owed as a whole.
  owed = std::min(owed, delays.empty() ? passed : std::max(passed, delays.front()));
  if (disk) {
    const double given = std::min({passed, longest_disk_step, disk_left_});
    disk_left_ -= given;
    owed = std::max(owed, given);
  }
  if (begun_) used_ += std::max(grown, team.processor_seconds - processor_ - rounding);
  begun_ = true;
  processor_ = team.processor_seconds;
  time.used_seconds = used_;
  delay_ += owed;
  time.delay_seconds = delay_;
  threads_ = std::move(seen);
  last_ = now;
  return time;
}

}  // namespace host

#pragma once

#include <sched.h>

namespace host {

/// Binds this process to one processor for the life of this object and lets the processes there take turns;
/// children inherit both.
///
/// Three processes that take turns are three times faster on one core than spread over several (reference
/// "physics", section 2: waking a process on another core costs more than the work). With the policy
/// SCHED_BATCH a process that is woken waits until the one that woke it waits itself: 3.0 switches a tick
/// instead of 5.4, since the host writes to both teams before either runs.
class BoundToProcessor {
 public:
  /// @param cpu  -1: nothing is done
  /// @throws std::invalid_argument when there is no such processor for us
  explicit BoundToProcessor(int cpu);
  BoundToProcessor(const BoundToProcessor&) = delete;
  BoundToProcessor& operator=(const BoundToProcessor&) = delete;
  ~BoundToProcessor();

 private:
  bool bound_ = false;
  bool patient_ = false;  // the policy was changed
  cpu_set_t before_{};
};

}  // namespace host

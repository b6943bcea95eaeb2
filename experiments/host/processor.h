#pragma once

#include <sched.h>

namespace host {

/// Binds this process to one processor for the life of this object; children inherit it.
///
/// Three processes that take turns are three times faster on one core than spread over several (reference
/// "physics", section 2: waking a process on another core costs more than the work).
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
  cpu_set_t before_{};
};

}  // namespace host

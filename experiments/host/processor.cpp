#include "experiments/host/processor.h"

#include <cstddef>
#include <stdexcept>
#include <string>

namespace host {

BoundToProcessor::BoundToProcessor(int cpu) {
  if (cpu < 0) return;
  cpu_set_t wanted;
  CPU_ZERO(&wanted);
  if (cpu < CPU_SETSIZE) CPU_SET(static_cast<std::size_t>(cpu), &wanted);
  if (::sched_getaffinity(0, sizeof before_, &before_) != 0 ||
      ::sched_setaffinity(0, sizeof wanted, &wanted) != 0) {
    throw std::invalid_argument("cpu " + std::to_string(cpu) + ": this machine has no such processor for us");
  }
  bound_ = true;
  // Only from the ordinary policy, and only if the system lets us: it is speed, not correctness.
  const sched_param none{};
  patient_ = ::sched_getscheduler(0) == SCHED_OTHER && ::sched_setscheduler(0, SCHED_BATCH, &none) == 0;
}

BoundToProcessor::~BoundToProcessor() {
  if (bound_) ::sched_setaffinity(0, sizeof before_, &before_);
  const sched_param none{};
  if (patient_) ::sched_setscheduler(0, SCHED_OTHER, &none);
}

}  // namespace host

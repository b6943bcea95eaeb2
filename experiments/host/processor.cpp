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
}

BoundToProcessor::~BoundToProcessor() {
  if (bound_) ::sched_setaffinity(0, sizeof before_, &before_);
}

}  // namespace host

#include "experiments/runner/leftovers.h"

#include "experiments/process/family.h"
#include "experiments/runner/worker.h"

namespace runner {

Leftovers::Leftovers(const std::filesystem::path& folder)
    : mark_(game_variable + ("=" + folder.string() + "/")), not_ours_(process::children()) {
  process::adopt_orphans();
}

std::size_t Leftovers::end() const {
  const std::size_t marked = process::end_started_with(mark_);
  return marked + process::end_adopted(not_ours_);
}

void Leftovers::reap(std::vector<pid_t> held) const {
  held.insert(held.end(), not_ours_.begin(), not_ours_.end());
  process::reap_adopted(held);
}

std::string processes(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " process" : " processes");
}

}  // namespace runner

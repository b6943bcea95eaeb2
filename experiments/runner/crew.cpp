#include "experiments/runner/crew.h"

#include <sched.h>

#include <algorithm>
#include <array>
#include <cassert>

namespace runner {
namespace {

/// The processors this process may use.
std::vector<int> processors() {
  cpu_set_t set;
  CPU_ZERO(&set);
  ::sched_getaffinity(0, sizeof set, &set);
  std::vector<int> found;
  for (int cpu = 0; cpu < CPU_SETSIZE; ++cpu) {
    if (CPU_ISSET(static_cast<std::size_t>(cpu), &set)) found.push_back(cpu);
  }
  return found;
}

}  // namespace

const char* name(Purpose purpose) {
  constexpr std::array<const char*, 3> names = {"game", "audit", "preflight"};
  return names.at(static_cast<std::size_t>(purpose));
}

Crew::Crew(std::vector<std::string> command, const WorkerLimits& limits, int places,
           const std::filesystem::path& scratch_note)
    : command_(std::move(command)),
      limits_(limits),
      scratch_(scratch_note),
      cpus_(processors()),
      slots_(places > 0 ? static_cast<std::size_t>(places) : cpus_.size()) {}

std::size_t Crew::running() const {
  return static_cast<std::size_t>(
      std::count_if(slots_.begin(), slots_.end(), [](const Slot& slot) { return slot.worker != nullptr; }));
}

std::size_t Crew::start(Purpose purpose, Job job, const std::filesystem::path& folder,
                        const std::string& date) {
  const auto slot =
      std::find_if(slots_.begin(), slots_.end(), [](const Slot& one) { return one.worker == nullptr; });
  assert(slot != slots_.end());
  const auto number = static_cast<std::size_t>(slot - slots_.begin());
  Place place;
  place.slot = static_cast<int>(number);
  place.cpu = cpus_[number % cpus_.size()];
  place.folder = folder;
  place.scratch = scratch_.of(place.slot);
  place.started = date;
  slot->worker = std::make_unique<Worker>(command_, limits_, std::move(job), std::move(place));
  slot->purpose = purpose;
  return number;
}

std::vector<Crew::Ended> Crew::collect() {
  std::vector<Ended> all;
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    Slot& slot = slots_[i];
    if (!slot.worker) continue;
    if (auto attempt = slot.worker->poll()) {
      all.push_back({i, slot.purpose, *std::move(attempt), slot.worker->seconds(), slot.worker->strays()});
      slot.worker.reset();
    }
  }
  return all;
}

void Crew::end() {
  for (Slot& slot : slots_) {
    if (slot.worker) slot.worker->ask_to_end();
  }
  for (Slot& slot : slots_) {
    if (slot.worker) slot.worker->stop();
    slot.worker.reset();
  }
}

std::vector<pid_t> Crew::pids() const {
  std::vector<pid_t> pids;
  for (const Slot& slot : slots_) {
    if (slot.worker) pids.push_back(slot.worker->pid());
  }
  return pids;
}

std::vector<Status::Game> Crew::games() const {
  std::vector<Status::Game> games;
  for (const Slot& slot : slots_) {
    if (!slot.worker) continue;
    const Job& job = slot.worker->job();
    games.push_back({record::game_id(job.game.key), job.attempt, name(slot.purpose), slot.worker->simulated(),
                     slot.worker->seconds()});
  }
  return games;
}

}  // namespace runner

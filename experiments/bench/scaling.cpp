#include "experiments/bench/scaling.h"

#include <sched.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <span>
#include <stdexcept>
#include <string>

#include "experiments/host/play.h"

namespace bench {
namespace {

// A process of its own, as the runner has one for each worker; its exit code says whether the game finished.
pid_t start(const record::MatchConfig& game, int cpu) {
  const pid_t child = ::fork();
  if (child < 0) throw std::runtime_error("a worker of the benchmark did not start: no process to be had");
  if (child > 0) return child;
  host::Options how;
  how.cpu = cpu;
  const record::MatchRecord record = host::play(game, how);
  ::_exit(record.termination == record::Termination::Finished ? 0 : 1);
}

bool finished(pid_t child) {
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

// Games per hour of a game on each of these processors at once.
double games_per_hour(const record::MatchConfig& game, std::span<const int> cpus) {
  const auto begin = std::chrono::steady_clock::now();
  std::vector<pid_t> children;
  for (const int cpu : cpus) children.push_back(start(game, cpu));
  bool all = true;
  for (const pid_t child : children) all = finished(child) && all;
  if (!all) throw std::runtime_error("a game of the benchmark's workers did not finish");
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
  return 3600 * static_cast<double>(cpus.size()) / taken.count();
}

}  // namespace

std::vector<int> processors() {
  cpu_set_t ours;
  std::vector<int> result;
  if (::sched_getaffinity(0, sizeof ours, &ours) != 0) return result;
  for (int cpu = 0; cpu < CPU_SETSIZE; ++cpu) {
    if (CPU_ISSET(static_cast<std::size_t>(cpu), &ours)) result.push_back(cpu);
  }
  return result;
}

Scaling measure_scaling(const record::MatchConfig& game, int workers) {
  const std::vector<int> cpus = processors();
  if (workers < 1 || static_cast<std::size_t>(workers) > cpus.size()) {
    throw std::invalid_argument("workers " + std::to_string(workers) + ": 1 to " +
                                std::to_string(cpus.size()) +
                                " are possible, one for each processor we may use");
  }
  const std::span<const int> all(cpus.data(), static_cast<std::size_t>(workers));
  Scaling scaling{workers};
  scaling.alone = games_per_hour(game, all.first(1)) / 2;
  scaling.together = games_per_hour(game, all);
  scaling.alone += games_per_hour(game, all.first(1)) / 2;
  return scaling;
}

}  // namespace bench

#pragma once

#include <sys/types.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace runner {

/// Ends whatever games of a result folder have left behind: when told, and when it goes, so also when an
/// error ends the run.
class Leftovers {
 public:
  /// From now on orphans among our descendants are ours.
  explicit Leftovers(const std::filesystem::path& folder);
  Leftovers(const Leftovers&) = delete;
  Leftovers& operator=(const Leftovers&) = delete;
  ~Leftovers() { end(); }

  /// How many processes there were.
  std::size_t end() const;

  /// Reaps orphans that have died.
  /// @param held  children that are reaped by their owners
  void reap(std::vector<pid_t> held) const;

 private:
  std::string mark_;
  std::vector<pid_t> not_ours_;  ///< children there were before the run
};

/// "1 process", "3 processes"
std::string processes(std::size_t count);

}  // namespace runner

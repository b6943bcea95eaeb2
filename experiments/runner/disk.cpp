#include "experiments/runner/disk.h"

#include <limits>

#include "experiments/process/tree.h"

namespace runner {

namespace fs = std::filesystem;

std::int64_t free_bytes(const fs::path& folder) {
  std::error_code error;
  const fs::space_info space = fs::space(folder, error);
  constexpr auto most = std::numeric_limits<std::int64_t>::max();
  if (error || space.available > static_cast<std::uintmax_t>(most)) return most;
  return static_cast<std::int64_t>(space.available);
}

std::int64_t size_of(const fs::path& folder) {
  constexpr process::TreeBounds bounds{.entries = 1'000'000,
                                       .depth = 256};  // ours: a team makes 10,000 at most
  return process::tree_size(folder, bounds).bytes;
}

}  // namespace runner

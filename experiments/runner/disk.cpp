#include "experiments/runner/disk.h"

#include <limits>

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
  std::int64_t sum = 0;
  std::error_code error;
  for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    std::error_code ignored;
    if (!entry->is_regular_file(ignored)) continue;
    const std::uintmax_t size = entry->file_size(ignored);
    if (!ignored) sum += static_cast<std::int64_t>(size);
  }
  return sum;
}

}  // namespace runner

#include "experiments/runner/disk_watch.h"

#include <utility>

namespace runner {

DiskWatch::DiskWatch(std::filesystem::path folder, std::int64_t needed,
                     std::function<std::int64_t(const std::filesystem::path&)> free_bytes,
                     std::chrono::milliseconds patience)
    : folder_(std::move(folder)), needed_(needed), free_bytes_(std::move(free_bytes)), patience_(patience) {}

DiskWatch::News DiskWatch::look(Clock::time_point now, bool idle) {
  free_ = free_bytes_(folder_);
  if (free_ >= needed_) return std::exchange(waiting_, std::nullopt) ? News::Room : News::None;
  if (!waiting_) {
    waiting_ = now;
    return News::Full;
  }
  return idle && now - *waiting_ > patience_ ? News::GiveUp : News::None;
}

std::string DiskWatch::sentence() const {
  return "the disk of " + folder_.string() + " has " + mebibytes(free_) + " left, " + mebibytes(needed_) +
         " are needed (limits.free_disk)";
}

std::string mebibytes(std::int64_t bytes) { return std::to_string(bytes >> 20) + " MiB"; }

}  // namespace runner

#pragma once

#include <filesystem>
#include <functional>

namespace builds {

/// A file that one process at a time may hold, made when it is missing. The lock goes with the process.
class FileLock {
 public:
  /// Waits until it is free; `waiting` is called once when it is not free at once.
  ///
  /// @throws std::runtime_error naming the file when it cannot be made
  FileLock(const std::filesystem::path& file, const std::function<void()>& waiting);
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;
  ~FileLock();

 private:
  int file_ = -1;
};

}  // namespace builds

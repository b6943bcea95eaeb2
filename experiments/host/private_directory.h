#pragma once

#include <filesystem>

namespace host {

/// A directory of our own (mode 0700) in the system's temporary directory, gone with this object.
///
/// It is locked, so that the next one to be made can tell those that a killed program has
/// left, and removes them.
class PrivateDirectory {
 public:
  /// @throws std::runtime_error naming the directory
  PrivateDirectory();
  PrivateDirectory(const PrivateDirectory&) = delete;
  PrivateDirectory& operator=(const PrivateDirectory&) = delete;
  ~PrivateDirectory();

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  int lock_ = -1;
};

}  // namespace host

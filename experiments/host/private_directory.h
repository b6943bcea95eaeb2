#pragma once

#include <filesystem>

namespace host {

/// A directory of our own (mode 0700) in the system's temporary directory, gone with this object.
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
};

}  // namespace host

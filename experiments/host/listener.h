#pragma once

#include <filesystem>
#include <optional>

namespace host {

/// A listening Unix stream socket for one team.
class Listener {
 public:
  /// @throws std::runtime_error naming the path when it cannot be made (too long: 107 bytes are possible)
  explicit Listener(std::filesystem::path path);
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;
  ~Listener();

  const std::filesystem::path& path() const { return path_; }
  int file() const { return file_; }

  /// The connected socket of the next who came, owned by the caller; nothing when nobody has come yet.
  std::optional<int> accept();

 private:
  std::filesystem::path path_;
  int file_ = -1;
};

}  // namespace host

#pragma once

#include <filesystem>
#include <string>

namespace runner {

/// A folder for the temporary files of all games of a run, in the system's folder for such (sockets need
/// short names, so not in the result folder).
///
/// The result folder remembers its name, so that the next run removes what a killed one has left.
class Scratch {
 public:
  /// @param note  file that remembers the name
  /// @throws record::StorageError when it cannot be made
  explicit Scratch(std::filesystem::path note);
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  ~Scratch();

  /// For the games of one slot.
  std::filesystem::path of(int slot) const { return path_ / std::to_string(slot); }

 private:
  std::filesystem::path note_;
  std::filesystem::path path_;
};

}  // namespace runner

#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

// Files of others, read without ever waiting for anybody.
namespace files {

/// Why a path cannot be read as a file, as "is a named pipe (FIFO), a regular file is needed". Empty for a
/// regular file, and for what is not there or may not be looked at: opening it says why.
std::string not_regular(const std::filesystem::path& file);

/// A regular file open for reading. Anything else is refused without being opened: opening a pipe waits for
/// its writer, and a device has no end.
class RegularFile {
 public:
  /// @throws std::runtime_error "FILE: is a named pipe (FIFO), a regular file is needed", "FILE: cannot be
  /// read: No such file or directory"; a std::system_error when the machine lacks memory or descriptors
  explicit RegularFile(const std::filesystem::path& file);
  RegularFile(const RegularFile&) = delete;
  RegularFile& operator=(const RegularFile&) = delete;
  ~RegularFile();

  /// Reads up to `size` bytes; fewer only at the end.
  /// @throws std::runtime_error "FILE: cannot be read: Input/output error"
  std::size_t read(char* data, std::size_t size);

  /// The descriptor, for whoever closes it from now on.
  int release();

 private:
  std::string name_;
  int descriptor_ = -1;
};

/// All bytes of a regular file.
///
/// @param most  bytes, a whole number of MiB
/// @throws std::runtime_error as above, and "FILE: has more than 1 MiB"
std::string text_of(const std::filesystem::path& file, std::size_t most);

}  // namespace files

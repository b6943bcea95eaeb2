#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>

// Plain and gzip files as streams of bytes, for sim/wire's own sources only. The name decides: ".gz" is gzip.
namespace wire {

/// A file being written. Every error throws OutputError naming the file, and removes it: what is on the disk
/// then is not whole.
class ByteSink {
 public:
  virtual ~ByteSink() = default;
  virtual void write(const char* data, std::size_t size) = 0;
  virtual void close() = 0;
};

/// A file being read.
class ByteSource {
 public:
  virtual ~ByteSource() = default;
  /// Reads up to `size` bytes; fewer only at the end.
  /// @throws std::runtime_error saying what is wrong, without the file's name
  virtual std::size_t read(char* data, std::size_t size) = 0;
  /// After the end: the packed file stops before its packed data does.
  virtual bool cut() const = 0;
};

/// Never waits: a named pipe must have its reader already. Devices are written as they are.
std::unique_ptr<ByteSink> open_sink(const std::filesystem::path& path);
/// Regular files only.
std::unique_ptr<ByteSource> open_source(const std::filesystem::path& path);

}  // namespace wire

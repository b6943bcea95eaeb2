#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>

#include "sim/proto/recording.pb.h"

namespace wire {

namespace proto {
using namespace matchday::recording;  // NOLINT: that is the purpose
}

inline constexpr std::uint32_t recording_version = 1;

/// A recording being written; a name that ends in .gz is packed. Errors throw std::runtime_error naming the
/// file.
class RecordingWriter {
 public:
  explicit RecordingWriter(const std::filesystem::path& path);
  ~RecordingWriter();

  void write(const proto::Recorded& record);
  void close();

 private:
  struct File;
  std::unique_ptr<File> file_;
};

/// A recording being read.
class RecordingReader {
 public:
  /// Reads the start.
  /// @throws std::runtime_error naming the file when it cannot be read, is no recording, or of another
  /// version
  explicit RecordingReader(const std::filesystem::path& path);
  ~RecordingReader();

  const proto::Start& start() const;

  /// The next tick, valid until the next call; null at the end, also of a file that was cut off in a record.
  /// @throws std::runtime_error naming file and place when what follows is not a tick
  const proto::Tick* next();
  /// After the end: the file stops in the middle of a record.
  bool cut() const;

 private:
  struct File;
  bool read_record();
  std::unique_ptr<File> file_;
};

}  // namespace wire

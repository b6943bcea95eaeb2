#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>

#include "sim/proto/recording.pb.h"

namespace wire {

namespace proto {
using namespace matchday::recording;  // NOLINT: that is the purpose
}

inline constexpr std::uint32_t recording_version = 2;

/// A recording being written; a name that ends in .gz is packed. Errors throw OutputError naming the file and
/// remove it. One that is not closed is one that was cut off.
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

/// A recording being read, of version 1 or 2. Of version 2 every record has a check, and a flipped bit
/// anywhere is noticed; of version 1 only what is no message.
class RecordingReader {
 public:
  /// Reads the start.
  /// @throws std::runtime_error naming the file when it cannot be read, is no recording,
  ///         or of another version
  explicit RecordingReader(const std::filesystem::path& path);
  ~RecordingReader();

  const proto::Start& start() const;

  /// The next tick, valid until the next call; null at the end, also of a file that was cut off.
  /// @throws std::runtime_error naming file and place when what follows is not what was written
  const proto::Tick* next();
  /// After the end: the file stops before its end, or, of version 1, in the middle of a record.
  bool cut() const;

 private:
  struct File;
  bool read_record();
  void read_end();
  std::unique_ptr<File> file_;
};

}  // namespace wire

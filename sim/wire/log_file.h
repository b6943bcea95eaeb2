#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace google::protobuf {
class MessageLite;
}

namespace wire {

/// What a record of a league log holds.
///
/// Real logs may hold the same vision frames twice, as Vision2010 and as Vision2014:
/// a reader that finds Vision2014 must leave Vision2010 alone, or it sees every frame twice.
/// Other types occur and are to be skipped.
enum LogType : std::int32_t {
  Vision2010 = 2,   ///< matchday::legacy2014::SSL_WrapperPacket
  Refbox2013 = 3,   ///< Referee
  Vision2014 = 4,   ///< SSL_WrapperPacket
  Tracker2020 = 5,  ///< TrackerWrapperPacket
  Index2021 = 6     ///< offsets of all records, the last one of a file; not a message
};

/// One received datagram: at most 65,507 bytes.
struct LogRecord {
  std::int64_t time_ns = 0;  ///< [ns, Unix] when it was received; 0 for an index
  std::int32_t type = 0;     ///< a LogType, or any other number
  std::string payload;       ///< empty for an index, which is passed over
};

/// Writes an SSL log file of version 1; gzip (level 1) when the name ends in ".gz".
///
/// All functions throw OutputError with one sentence naming the file when the disk
/// refuses; then it is removed.
class LogWriter {
 public:
  explicit LogWriter(const std::filesystem::path& path);
  LogWriter(LogWriter&&) noexcept;
  LogWriter& operator=(LogWriter&&) noexcept;
  /// Closes quietly; call `close` to hear of errors.
  ~LogWriter();

  /// @throws std::length_error for a payload that is longer than a datagram can be
  void write(std::int64_t time_ns, std::int32_t type, std::string_view payload);
  void write(std::int64_t time_ns, std::int32_t type, const google::protobuf::MessageLite& message);
  void write(const LogRecord& record) { write(record.time_ns, record.type, record.payload); }
  /// Flushes and closes; nothing may be written after it.
  void close();

 private:
  struct File;
  std::unique_ptr<File> file_;
};

/// Reads an SSL log file of version 1; gzip when the name ends in ".gz".
///
/// Source  the league's log format (reference "protocol", 4.1).
class LogReader {
 public:
  /// @throws std::runtime_error when the file cannot be opened, or is no log file of version 1
  explicit LogReader(const std::filesystem::path& path);
  LogReader(LogReader&&) noexcept;
  LogReader& operator=(LogReader&&) noexcept;
  ~LogReader();

  /// Reads the next record into memory that is used again; false at the end of the file.
  ///
  /// A last record cut short (the recorder was killed) ends the file quietly, as is the league's custom;
  /// `truncated` then says so. Takes as much memory as one datagram, whatever the file is.
  ///
  /// @throws std::runtime_error "file: record N at byte B: ..." for a length that is negative
  ///         or above that of a datagram (of an index: 64 MiB), and for damaged gzip data.
  ///         Records count from 1, bytes from the start of the unpacked file.
  bool next(LogRecord& record);

  /// After the end: the file stops inside a record, or its gzip stream does.
  bool truncated() const;
  /// After the end: one sentence "file: record N at byte B: ..." about the missing piece;
  /// empty when nothing is.
  const std::string& truncation() const;
  /// Records returned so far.
  std::int64_t records() const;

 private:
  struct File;
  std::unique_ptr<File> file_;
};

}  // namespace wire

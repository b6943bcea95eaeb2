#include "sim/wire/recording.h"

#include <xxhash.h>

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "sim/wire/byte_file.h"
#include "sim/wire/delimited.h"

namespace wire {
namespace {

// Field 15, fixed64: one byte of tag and eight of value, little end first.
constexpr char check_tag = (15 << 3) | 1;
constexpr std::size_t check_size = 9;
constexpr const char* not_as_written = "is not what was written: the file is damaged";

/// Of a record's bytes without their check, after a record with the check `before`.
std::uint64_t check_of(std::string_view bytes, std::uint64_t before) {
  return XXH3_64bits_withSeed(bytes.data(), bytes.size(), before);
}

void append_check(std::string& bytes, std::uint64_t check) {
  bytes.push_back(check_tag);
  for (int i = 0; i < 8; ++i) bytes.push_back(static_cast<char>(check >> (8 * i) & 0xFF));
}

}  // namespace

struct RecordingWriter::File {
  std::unique_ptr<ByteSink> sink;
  std::string bytes{};  // used again for every record
  std::uint64_t check = 0;
  std::int64_t ticks = 0;
};

RecordingWriter::RecordingWriter(const std::filesystem::path& path) : file_(new File{open_sink(path)}) {}
RecordingWriter::~RecordingWriter() = default;

void RecordingWriter::write(const proto::Recorded& record) {
  File& file = *file_;
  file.bytes.clear();
  const std::size_t size = record.ByteSizeLong() + check_size;
  if (size > max_frame_size) {
    throw FrameError("a record of " + std::to_string(size) + " bytes is longer than the " +
                     std::to_string(max_frame_size) + " allowed");
  }
  append_frame_header(file.bytes, size);
  const std::size_t header = file.bytes.size();
  record.AppendPartialToString(&file.bytes);
  file.check = check_of(std::string_view(file.bytes).substr(header), file.check);
  append_check(file.bytes, file.check);
  file.sink->write(file.bytes.data(), file.bytes.size());
  if (record.has_tick()) ++file.ticks;
}

void RecordingWriter::close() {
  proto::Recorded end;
  end.mutable_end()->set_ticks(file_->ticks);
  write(end);
  const std::unique_ptr<ByteSink> sink = std::move(file_->sink);
  sink->close();
}

struct RecordingReader::File {
  std::string name;
  std::unique_ptr<ByteSource> source;
  FrameReader frames;
  std::vector<char> buffer = std::vector<char>(1 << 16);
  proto::Recorded record;
  proto::Start start;
  std::int64_t records = 0;  // read so far
  std::uint64_t check = 0;   // of the last one
  bool ended = false;        // the end was read

  /// Whether the bytes of a record end with the check of the others.
  bool checked(std::string_view bytes) {
    if (bytes.size() < check_size) return false;
    const std::string_view others = bytes.substr(0, bytes.size() - check_size);
    const std::uint64_t found = check_of(others, check);
    std::string expected;
    append_check(expected, found);
    if (bytes.substr(others.size()) != expected) return false;
    check = found;
    return true;
  }
  /// Version 1 had no checks; before the start is read it may be one.
  bool may_be_unchecked() const { return records == 0 || start.version() == 1; }
  bool is_unchecked() const {
    return !record.has_check() && (records == 0 ? record.start().version() : start.version()) == 1;
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw std::runtime_error(name + ": record " + std::to_string(records + 1) + " " + what);
  }
};

RecordingReader::RecordingReader(const std::filesystem::path& path) : file_(std::make_unique<File>()) {
  file_->name = path.string();
  file_->source = open_source(path);
  bool is_recording = false;
  try {
    is_recording = read_record() && file_->record.has_start();
  } catch (const std::runtime_error&) {
    // Another kind of file does not even look like records; one of ours says that it is damaged.
    if (file_->record.has_start()) throw;
  }
  if (!is_recording) {
    throw std::runtime_error(file_->name +
                             ": not a recording of a game (as `matchday play --record` writes it)");
  }
  file_->start = file_->record.start();
  if (file_->start.version() < 1 || file_->start.version() > recording_version) {
    throw std::runtime_error(file_->name + ": a recording of version " +
                             std::to_string(file_->start.version()) + ", this program reads versions up to " +
                             std::to_string(recording_version));
  }
}
RecordingReader::~RecordingReader() = default;

const proto::Start& RecordingReader::start() const { return file_->start; }

const proto::Tick* RecordingReader::next() {
  if (file_->ended || !read_record()) return nullptr;
  if (file_->record.has_end() && file_->start.version() > 1) {
    read_end();
    return nullptr;
  }
  if (!file_->record.has_tick()) file_->fail("is not a tick: the file is damaged");
  return &file_->record.tick();
}

void RecordingReader::read_end() {
  File& file = *file_;
  // The start and the end are no ticks.
  if (file.record.end().ticks() != file.records - 2) file.fail("counts other ticks: the file is damaged");
  file.ended = true;
  // Reading on also makes the packed file compare its own checksum.
  if (read_record() || file.frames.pending() > 0) file.fail("stands behind the end: the file is damaged");
  if (file.source->cut()) file.ended = false;
}

bool RecordingReader::cut() const {
  const bool whole = file_->start.version() == 1 || file_->ended;
  return !whole || file_->frames.pending() > 0 || file_->source->cut();
}

bool RecordingReader::read_record() {
  File& file = *file_;
  try {
    while (true) {
      if (const auto payload = file.frames.next()) {
        const bool checked = file.checked({reinterpret_cast<const char*>(payload->data()), payload->size()});
        if (!checked && !file.may_be_unchecked()) file.fail(not_as_written);
        if (!file.record.ParseFromArray(payload->data(), static_cast<int>(payload->size()))) {
          file.fail("cannot be read: the file is damaged");
        }
        if (!checked && !file.is_unchecked()) file.fail(not_as_written);
        ++file.records;
        return true;
      }
      std::size_t size = 0;
      try {
        size = file.source->read(file.buffer.data(), file.buffer.size());
      } catch (const std::runtime_error& error) {
        throw std::runtime_error(file.name + ": " + error.what());
      }
      if (size == 0) return false;
      file.frames.append(std::as_bytes(std::span(file.buffer.data(), size)));
    }
  } catch (const FrameError& error) {
    file.fail(std::string("cannot be read: ") + error.what());
  }
}

}  // namespace wire

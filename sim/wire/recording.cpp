#include "sim/wire/recording.h"

#include <stdexcept>
#include <string>
#include <vector>

#include "sim/wire/byte_file.h"
#include "sim/wire/delimited.h"

namespace wire {

struct RecordingWriter::File {
  std::unique_ptr<ByteSink> sink;
  std::string bytes;  // used again for every record
};

RecordingWriter::RecordingWriter(const std::filesystem::path& path) : file_(new File{open_sink(path), {}}) {}
RecordingWriter::~RecordingWriter() = default;

void RecordingWriter::write(const proto::Recorded& record) {
  file_->bytes.clear();
  append_frame(file_->bytes, record);
  file_->sink->write(file_->bytes.data(), file_->bytes.size());
}

void RecordingWriter::close() {
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
    // Another kind of file does not even look like records.
  }
  if (!is_recording) {
    throw std::runtime_error(file_->name +
                             ": not a recording of a game (as `matchday play --record` writes it)");
  }
  file_->start = file_->record.start();
  if (file_->start.version() != recording_version) {
    throw std::runtime_error(file_->name + ": a recording of version " +
                             std::to_string(file_->start.version()) + ", this program reads version " +
                             std::to_string(recording_version));
  }
}
RecordingReader::~RecordingReader() = default;

const proto::Start& RecordingReader::start() const { return file_->start; }

const proto::Tick* RecordingReader::next() {
  if (!read_record()) return nullptr;
  if (!file_->record.has_tick()) file_->fail("is not a tick: the file is damaged");
  return &file_->record.tick();
}

bool RecordingReader::cut() const { return file_->frames.pending() > 0 || file_->source->cut(); }

bool RecordingReader::read_record() {
  File& file = *file_;
  try {
    while (true) {
      if (const auto payload = file.frames.next()) {
        if (!file.record.ParseFromArray(payload->data(), static_cast<int>(payload->size()))) {
          file.fail("cannot be read: the file is damaged");
        }
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

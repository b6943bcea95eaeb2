#include "sim/wire/log_file.h"

#include <google/protobuf/message_lite.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <stdexcept>

#include "sim/wire/byte_file.h"

namespace wire {

namespace {

constexpr std::string_view magic = "SSL_LOG_FILE";
constexpr std::uint32_t version = 1;
constexpr std::size_t header_size = 16;       // of the file, and of each record
constexpr std::int32_t max_message = 65'507;  // [bytes] the longest payload of a UDP datagram over IPv4
// Ours: the index of a game of an hour has about 8 MiB. It is passed over, not kept.
constexpr std::int32_t max_index = 64 << 20;  // [bytes]
constexpr std::size_t piece = 1 << 16;        // [bytes] of what is passed over

using Header = std::array<char, header_size>;

// Everything is big-endian.
template <class Unsigned>
void put(Unsigned value, char* out) {
  for (std::size_t i = 0; i < sizeof(Unsigned); ++i) {
    out[i] = static_cast<char>(static_cast<unsigned char>(value >> (8 * (sizeof(Unsigned) - 1 - i))));
  }
}

template <class Unsigned>
Unsigned get(const char* in) {
  Unsigned value = 0;
  for (std::size_t i = 0; i < sizeof(Unsigned); ++i) {
    value = static_cast<Unsigned>(value << 8 | static_cast<unsigned char>(in[i]));
  }
  return value;
}

}  // namespace

struct LogWriter::File {
  std::unique_ptr<ByteSink> sink;
  std::string bytes;  // used again for every message
};

LogWriter::LogWriter(const std::filesystem::path& path) : file_(new File{open_sink(path), {}}) {
  Header header;
  magic.copy(header.data(), magic.size());
  put(version, header.data() + magic.size());
  file_->sink->write(header.data(), header.size());
}
LogWriter::LogWriter(LogWriter&&) noexcept = default;
LogWriter& LogWriter::operator=(LogWriter&&) noexcept = default;
LogWriter::~LogWriter() = default;

void LogWriter::write(std::int64_t time_ns, std::int32_t type, std::string_view payload) {
  assert(file_->sink);
  if (payload.size() > static_cast<std::size_t>(max_message)) {
    throw std::length_error("a message of " + std::to_string(payload.size()) +
                            " bytes is no datagram, which has at most " + std::to_string(max_message) +
                            ": not written to the league log");
  }
  Header header;
  put(static_cast<std::uint64_t>(time_ns), header.data());
  put(static_cast<std::uint32_t>(type), header.data() + 8);
  put(static_cast<std::uint32_t>(payload.size()), header.data() + 12);
  file_->sink->write(header.data(), header.size());
  file_->sink->write(payload.data(), payload.size());
}

void LogWriter::write(std::int64_t time_ns, std::int32_t type, const google::protobuf::MessageLite& message) {
  file_->bytes.clear();
  message.AppendPartialToString(&file_->bytes);
  write(time_ns, type, file_->bytes);
}

void LogWriter::close() {
  assert(file_->sink);
  const std::unique_ptr<ByteSink> sink = std::move(file_->sink);
  sink->close();
}

struct LogReader::File {
  std::string name;
  std::unique_ptr<ByteSource> source;
  std::int64_t records = 0;  // returned so far
  std::int64_t begin = 0;    // [bytes] of the record being read
  bool at_end = false;
  std::string truncation;

  std::string place() const {
    return name + ": record " + std::to_string(records + 1) + " at byte " + std::to_string(begin) + ": ";
  }
  std::size_t read(char* data, std::size_t size) {
    try {
      return source->read(data, size);
    } catch (const std::runtime_error& error) {
      throw std::runtime_error(place() + error.what());
    }
  }
  /// Reads that many bytes without keeping them; how many there were.
  std::size_t pass_over(std::size_t size) {
    std::string bytes(std::min(size, piece), '\0');
    std::size_t total = 0;
    while (total < size) {
      const std::size_t wanted = std::min(size - total, bytes.size());
      const std::size_t got = read(bytes.data(), wanted);
      total += got;
      if (got < wanted) break;
    }
    return total;
  }
  /// Ends the file quietly; something is missing if `missing` says so.
  bool end(const std::string& missing) {
    at_end = true;
    if (!missing.empty()) truncation = place() + missing;
    return false;
  }
};

namespace {

std::string wrong_start(const Header& header, std::size_t size) {
  constexpr std::string_view gzip_magic = "\x1f\x8b";
  constexpr std::string_view version_0 = {"\0\0\0\x18\0S\0S\0L", 10};  // a string of Qt, 16 bits a letter
  const std::string_view start(header.data(), size);
  if (start.starts_with(gzip_magic)) return "is gzip data; its name must end in .gz";
  if (start.starts_with(version_0))
    return "is a log file of version 0 (before 2013); only version 1 can be read";
  if (size < header_size)
    return "is too short for a log file: " + std::to_string(size) + " bytes, at least 16 needed";
  return "is not an SSL log file: it does not begin with SSL_LOG_FILE";
}

}  // namespace

LogReader::LogReader(const std::filesystem::path& path)
    : file_(new File{path.string(), open_source(path), 0, header_size, false, {}}) {
  Header header;
  std::size_t size = 0;
  try {
    size = file_->source->read(header.data(), header.size());
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(file_->name + ": " + error.what());
  }
  if (size < header_size || std::string_view(header.data(), magic.size()) != magic) {
    throw std::runtime_error(file_->name + ": " + wrong_start(header, size));
  }
  const auto found = get<std::uint32_t>(header.data() + magic.size());
  if (found != version) {
    throw std::runtime_error(file_->name + ": is a log file of version " +
                             std::to_string(static_cast<std::int32_t>(found)) +
                             "; only version 1 can be read");
  }
}
LogReader::LogReader(LogReader&&) noexcept = default;
LogReader& LogReader::operator=(LogReader&&) noexcept = default;
LogReader::~LogReader() = default;

bool LogReader::next(LogRecord& record) {
  File& file = *file_;
  if (file.at_end) return false;

  Header header;
  const std::size_t got = file.read(header.data(), header.size());
  if (got == 0) return file.end(file.source->cut() ? "the gzip data stop before their end" : "");
  if (got < header.size()) {
    return file.end("cut short, " + std::to_string(got) + " of the 16 bytes of its header are there");
  }
  record.time_ns = static_cast<std::int64_t>(get<std::uint64_t>(header.data()));
  record.type = static_cast<std::int32_t>(get<std::uint32_t>(header.data() + 8));
  const auto length = static_cast<std::int32_t>(get<std::uint32_t>(header.data() + 12));
  const bool is_index = record.type == Index2021;
  const std::int32_t longest = is_index ? max_index : max_message;
  if (length < 0 || length > longest) {  // before memory is taken for it
    throw std::runtime_error(file.place() + "its payload length is " + std::to_string(length) +
                             ", not 0 to " + std::to_string(longest) + " bytes; the file is damaged");
  }

  const auto size = static_cast<std::size_t>(length);
  record.payload.resize(is_index ? 0 : size);
  const std::size_t payload = is_index ? file.pass_over(size) : file.read(record.payload.data(), size);
  if (payload < size) {
    if (!is_index) record.payload.resize(payload);
    return file.end("cut short, " + std::to_string(payload) + " of its " + std::to_string(length) +
                    " bytes of payload are there");
  }
  ++file.records;
  file.begin += static_cast<std::int64_t>(header_size) + length;
  return true;
}

bool LogReader::truncated() const { return !file_->truncation.empty(); }
const std::string& LogReader::truncation() const { return file_->truncation; }
std::int64_t LogReader::records() const { return file_->records; }

}  // namespace wire

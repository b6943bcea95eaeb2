#include "tests/fuzz/mutators.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cstring>
#include <limits>
#include <optional>
#include <vector>

#include "sim/wire/delimited.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

namespace fuzz {
namespace {

using Limits = std::numeric_limits<double>;
using FloatLimits = std::numeric_limits<float>;

template <class Value>
std::string raw(Value value) {
  const auto bytes = std::bit_cast<std::array<char, sizeof value>>(value);
  return {bytes.data(), bytes.size()};
}

/// What a reader may have forgotten to think of.
const std::vector<std::string>& hard_values() {
  static const std::vector<std::string> values = {
      raw<std::uint8_t>(0),
      raw<std::uint8_t>(1),
      raw<std::uint8_t>(16),
      raw<std::uint8_t>(127),
      raw<std::uint8_t>(255),
      raw<std::uint16_t>(0),
      raw<std::uint16_t>(1),
      raw<std::uint16_t>(1000),
      raw<std::uint16_t>(65535),
      raw<std::int32_t>(-1),
      raw<std::int32_t>(0),
      raw<std::int32_t>(1'000'000),
      raw(std::numeric_limits<std::int32_t>::min()),
      raw(std::numeric_limits<std::int32_t>::max()),
      raw<std::int64_t>(-1),
      raw<std::int64_t>(0),
      raw<std::int64_t>(1'000'000'000),
      raw(std::numeric_limits<std::int64_t>::min()),
      raw(std::numeric_limits<std::int64_t>::max()),
      raw(FloatLimits::quiet_NaN()),
      raw(FloatLimits::infinity()),
      raw(FloatLimits::max()),
      raw(FloatLimits::min()),
      raw(0.0F),
      raw(1.0F),
      raw(-1000.0F),
      raw(100'000.0F),
      raw(Limits::quiet_NaN()),
      raw(-Limits::infinity()),
      raw(Limits::max()),
      raw(Limits::denorm_min()),
      raw(0.0),
      raw(1.0),
      raw(-1e9),
      raw(1e300),
      raw(1.7e9),
      raw(4e9),
  };
  return values;
}

const std::vector<std::string>& hard_numbers() {
  static const std::vector<std::string> numbers = {"0",
                                                   "-0",
                                                   "-1",
                                                   "1",
                                                   "0.5",
                                                   "16",
                                                   "255",
                                                   "256",
                                                   "65536",
                                                   "2147483647",
                                                   "2147483648",
                                                   "-2147483649",
                                                   "4294967296",
                                                   "9223372036854775807",
                                                   "-9223372036854775808",
                                                   "18446744073709551615",
                                                   "99999999999999999999",
                                                   "1e9",
                                                   "1e19",
                                                   "1e300",
                                                   "-1e300",
                                                   "1e999",
                                                   "1e-400",
                                                   "null",
                                                   "\"\"",
                                                   "[]",
                                                   "{}",
                                                   "true",
                                                   "nan",
                                                   "inf"};
  return numbers;
}

std::size_t below(std::size_t count, Random& random) { return count == 0 ? 0 : random() % count; }

std::string by_libfuzzer(std::string input, std::size_t most) {
  const std::size_t size = std::min(input.size(), most);
  input.resize(std::max<std::size_t>(most, 1));
  input.resize(LLVMFuzzerMutate(reinterpret_cast<std::uint8_t*>(input.data()), size, input.size()));
  return input;
}

/// Changes one part of a list: another content, twice, left out, another place.
template <class Part, class Mutate>
void change_one(std::vector<Part>& parts, Random& random, const Mutate& mutate) {
  if (parts.empty()) return;
  const std::size_t which = below(parts.size(), random);
  const auto at = parts.begin() + static_cast<std::ptrdiff_t>(which);
  switch (below(8, random)) {
    case 0:
      parts.insert(at, Part(parts[which]));
      break;
    case 1:
      parts.erase(at);
      break;
    case 2:
      std::swap(parts[which], parts[below(parts.size(), random)]);
      break;
    default:
      mutate(parts[which]);
  }
}

std::vector<std::string> frames_of(const std::string& input) {
  std::vector<std::string> frames;
  wire::FrameReader reader;
  reader.append(std::as_bytes(std::span(input)));
  try {
    while (const auto payload = reader.next()) {
      frames.emplace_back(reinterpret_cast<const char*>(payload->data()), payload->size());
    }
  } catch (const wire::FrameError&) {
    // What came before is enough.
  }
  return frames;
}

struct Record {
  std::string head;  // time and type
  std::string payload;
};
constexpr std::size_t log_header = 16, record_head = 12, record_length = 4;

std::vector<Record> records_of(const std::string& log) {
  std::vector<Record> records;
  std::size_t at = log_header;
  while (at + record_head + record_length <= log.size()) {
    std::size_t length = 0;
    for (std::size_t i = 0; i < record_length; ++i) {
      length = length << 8 | static_cast<unsigned char>(log[at + record_head + i]);
    }
    const std::size_t payload = at + record_head + record_length;
    records.push_back({log.substr(at, record_head), log.substr(payload, length)});
    at = payload + length;
  }
  return records;
}

std::optional<std::string> through_zlib(const std::string& input, std::size_t most, bool pack) {
  constexpr int gzip = 15 + 16;  // zlib's word for it
  z_stream stream{};
  const int begun =
      pack ? deflateInit2(&stream, 1, Z_DEFLATED, gzip, 8, Z_DEFAULT_STRATEGY) : inflateInit2(&stream, gzip);
  if (begun != Z_OK) return std::nullopt;
  std::string output(most, '\0');
  std::string copy = input;
  stream.next_in = reinterpret_cast<Bytef*>(copy.data());
  stream.avail_in = static_cast<uInt>(copy.size());
  stream.next_out = reinterpret_cast<Bytef*>(output.data());
  stream.avail_out = static_cast<uInt>(output.size());
  const int done = pack ? deflate(&stream, Z_FINISH) : inflate(&stream, Z_FINISH);
  output.resize(stream.total_out);
  pack ? deflateEnd(&stream) : inflateEnd(&stream);
  if (done != Z_STREAM_END) return std::nullopt;
  return output;
}

}  // namespace

std::string mutated_bytes(std::string input, std::size_t most, Random& random) {
  const std::string& value = hard_values()[below(hard_values().size(), random)];
  if (below(3, random) != 0 || input.size() < value.size()) return by_libfuzzer(std::move(input), most);
  input.replace(below(input.size() - value.size() + 1, random), value.size(), value);
  return input;
}

std::string mutated_text(std::string input, std::size_t most, Random& random) {
  const auto is_part = [](unsigned char letter) { return std::isdigit(letter) != 0; };
  std::vector<std::size_t> begins;
  for (std::size_t i = 0; i < input.size(); ++i) {
    if (is_part(static_cast<unsigned char>(input[i])) &&
        (i == 0 || !is_part(static_cast<unsigned char>(input[i - 1])))) {
      begins.push_back(i);
    }
  }
  if (begins.empty() || below(3, random) != 0) return by_libfuzzer(std::move(input), most);
  const std::size_t begin = begins[below(begins.size(), random)];
  std::size_t end = begin;
  while (end < input.size() && (is_part(static_cast<unsigned char>(input[end])) || input[end] == '.')) ++end;
  input.replace(begin, end - begin, hard_numbers()[below(hard_numbers().size(), random)]);
  input.resize(std::min(input.size(), most));
  return input;
}

std::string mutated_frames(std::string input, std::size_t most, Random& random) {
  std::vector<std::string> frames = frames_of(input);
  if (frames.empty() || below(8, random) == 0) return by_libfuzzer(std::move(input), most);
  const std::size_t room = most > input.size() ? most - input.size() : 0;
  change_one(frames, random,
             [&](std::string& frame) { frame = mutated_bytes(frame, frame.size() + room / 2, random); });
  std::string output;
  for (const std::string& frame : frames) {
    wire::append_frame_header(output, frame.size());
    output += frame;
  }
  output.resize(std::min(output.size(), most));
  return output;
}

std::string mutated_log(std::string input, std::size_t most, Random& random) {
  std::vector<Record> records = records_of(input);
  if (records.empty() || below(8, random) == 0) return mutated_bytes(std::move(input), most, random);
  const std::size_t room = most > input.size() ? most - input.size() : 0;
  change_one(records, random, [&](Record& record) {
    if (below(8, random) == 0) record.head = by_libfuzzer(record.head, record_head);
    record.head.resize(record_head);
    record.payload = mutated_bytes(record.payload, record.payload.size() + room / 2, random);
  });
  std::string output = input.substr(0, log_header);
  for (const Record& record : records) {
    output += record.head;
    for (std::size_t i = 0; i < record_length; ++i) {
      output += static_cast<char>(record.payload.size() >> (8 * (record_length - 1 - i)) & 0xFF);
    }
    output += record.payload;
  }
  output.resize(std::min(output.size(), most));
  return output;
}

std::string mutated_packed(std::string input, std::size_t most, Random& random) {
  constexpr std::size_t most_unpacked = std::size_t{1} << 18;
  const auto log = through_zlib(input, most_unpacked, false);
  if (!log || below(4, random) == 0) return by_libfuzzer(std::move(input), most);
  const auto packed = through_zlib(mutated_log(*log, most_unpacked, random), most, true);
  return packed ? *packed : input;
}

}  // namespace fuzz

#include "sim/wire/delimited.h"

#include <cstdint>

namespace wire {

namespace {

constexpr int max_header_size = 5;  // [bytes] a 32-bit varint, as protobuf's own delimited readers accept

FrameError too_long(std::uint64_t size, std::size_t longest) {
  return FrameError("frame of " + std::to_string(size) + " bytes is longer than the " +
                    std::to_string(longest) + " allowed");
}

}  // namespace

void FrameReader::append(std::span<const std::byte> bytes) {
  if (pending() > max_frame_size + max_header_size) {  // a whole frame and more: nobody has asked for it
    throw FrameError(std::to_string(pending()) + " bytes wait to be read, which is more than a frame has");
  }
  if (begin_ > 0) {
    buffer_.erase(buffer_.begin(), buffer_.begin() + static_cast<std::ptrdiff_t>(begin_));
    begin_ = 0;
  }
  buffer_.insert(buffer_.end(), bytes.begin(), bytes.end());
}

std::optional<std::span<const std::byte>> FrameReader::next() {
  std::uint64_t size = 0;
  std::size_t position = begin_;
  for (int count = 0;; ++count) {
    if (count == max_header_size) throw FrameError("frame length is not a varint of at most 5 bytes");
    if (position == buffer_.size()) return std::nullopt;
    const auto byte = std::to_integer<std::uint64_t>(buffer_[position++]);
    size |= (byte & 0x7F) << (7 * count);
    if (byte < 0x80) break;
  }
  if (size > longest_) throw too_long(size, longest_);
  if (buffer_.size() - position < size) return std::nullopt;
  begin_ = position + size;
  return std::span<const std::byte>(buffer_).subspan(position, size);
}

void append_frame_header(std::string& out, std::size_t payload_size) {
  std::size_t rest = payload_size;
  while (rest >= 0x80) {
    out.push_back(static_cast<char>((rest & 0x7F) | 0x80));
    rest >>= 7;
  }
  out.push_back(static_cast<char>(rest));
}

void append_frame(std::string& out, const google::protobuf::MessageLite& message) {
  const std::size_t size = message.ByteSizeLong();
  if (size > max_frame_size) throw too_long(size, max_frame_size);
  append_frame_header(out, size);
  message.AppendPartialToString(&out);
}

}  // namespace wire

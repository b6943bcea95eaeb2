#pragma once

#include <google/protobuf/message_lite.h>

#include <cstddef>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace wire {

/// The byte stream is not a row of frames; nothing after it can be trusted.
struct FrameError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Longest payload of a frame [bytes] (design, "The channel between host and team").
inline constexpr std::size_t max_frame_size = std::size_t{1} << 20;

/// Cuts a byte stream into frames: a varint length, then as many bytes. Pure buffer, no sockets.
class FrameReader {
 public:
  /// @param longest  [bytes] payload of a frame that is accepted, at most max_frame_size
  explicit FrameReader(std::size_t longest = max_frame_size) : longest_(longest) {}

  /// Adds what was received. Ends the life of spans returned by `next`, which must be called until it returns
  /// nothing before more is added: so never more than a frame and one piece is kept.
  /// @throws FrameError when more than a whole frame was left
  void append(std::span<const std::byte> bytes);
  /// Payload of the next whole frame, valid until `append`; nothing when more bytes are needed.
  /// @throws FrameError when the length is above the longest or its varint above 5 bytes,
  ///         before the payload has come; then at every further call
  std::optional<std::span<const std::byte>> next();
  /// Bytes received but not yet returned: not zero at the end of a stream means it was cut in a frame.
  std::size_t pending() const { return buffer_.size() - begin_; }

 private:
  std::size_t longest_;
  std::vector<std::byte> buffer_;
  std::size_t begin_ = 0;  // first byte not yet returned
};

/// Appends the varint length of a payload that the caller appends next.
void append_frame_header(std::string& out, std::size_t payload_size);
/// Appends the message as one frame.
/// @throws FrameError when it is longer than 1 MiB
void append_frame(std::string& out, const google::protobuf::MessageLite& message);

}  // namespace wire

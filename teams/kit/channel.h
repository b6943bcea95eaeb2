#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "sim/wire/delimited.h"

namespace kit {

/// The stream to the host: whole frames in, whole frames out. Owns the file descriptor.
///
/// One read and one write per tick as long as the messages fit the socket's buffers.
class Channel {
 public:
  /// Takes over a connected, blocking stream socket.
  explicit Channel(int descriptor) : descriptor_(descriptor) {}
  Channel(const Channel&) = delete;
  Channel& operator=(const Channel&) = delete;
  ~Channel();

  /// Connects to a Unix stream socket.
  /// @throws std::runtime_error naming the path
  static int connect(const std::string& path);

  /// The next frame's payload, valid until the next call; nothing when the host closed the stream.
  /// @throws wire::FrameError for a damaged stream, std::runtime_error when reading fails or the stream ends
  ///         inside a frame
  std::optional<std::span<const std::byte>> read();

  /// @throws std::runtime_error when the host is gone
  void write(std::string_view bytes);

  /// How often the system was called for it, both ways.
  std::int64_t calls() const { return calls_; }

 private:
  int descriptor_;
  wire::FrameReader frames_;
  std::int64_t calls_ = 0;
};

}  // namespace kit

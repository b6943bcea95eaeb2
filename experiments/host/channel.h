#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "sim/wire/delimited.h"

namespace host {

/// Our end of the connection to one team: whole frames out, whole frames in.
///
/// Nothing here blocks for longer than `slice`, so that its owner can look after the rest of the game
/// meanwhile. In the usual case one frame costs one system call each way.
class Channel {
 public:
  enum class Status { Done, Waiting, Closed };
  static constexpr std::chrono::milliseconds slice{10};

  /// Takes the connected socket over.
  /// @param longest  [bytes] of a frame's payload that is accepted
  explicit Channel(int socket, std::size_t longest = wire::max_frame_size);
  Channel(Channel&& other) noexcept;
  Channel(const Channel&) = delete;
  Channel& operator=(Channel&&) = delete;
  Channel& operator=(const Channel&) = delete;
  ~Channel();

  enum class Full { Wait, Return };  ///< when the other side has not read what it was sent before
  /// Writes `rest` and removes from it what went out. Waiting: some is left; call again.
  Status send(std::string_view& rest, Full full);

  /// The next frame's payload, valid until the next call; Waiting: none came within a slice.
  /// @throws wire::FrameError when what came is not a frame, or one that is too long: before it is read
  Status receive(std::span<const std::byte>& payload);

  /// Whether bytes have come that were not read, or the other side has hung up.
  bool has_input() const;
  /// Whether bytes have come that were not read.
  bool has_bytes() const;
  /// [bytes] read, but not yet returned as a frame.
  std::size_t pending() const { return reader_.pending(); }
  int socket() const { return socket_; }

  std::int64_t bytes_in() const { return bytes_in_; }
  /// How often the system was called for it, both ways.
  std::int64_t calls() const { return calls_; }

 private:
  int socket_;
  wire::FrameReader reader_;
  std::vector<std::byte> buffer_;
  std::int64_t bytes_in_ = 0;
  std::int64_t calls_ = 0;
};

}  // namespace host

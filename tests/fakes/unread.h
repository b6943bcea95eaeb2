#pragma once

#include <poll.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <functional>
#include <thread>

// A team that answers ticks without reading them, so that the host cannot write the next one.
namespace fakes {

/// Bytes that have come and were not read.
inline int unread(int socket) {
  int count = 0;
  ::ioctl(socket, FIONREAD, &count);
  return count;
}

/// Answers what comes without reading it, until nothing comes any more: there is no room.
///
/// @return the last tick that was answered
inline std::int64_t fill_up(int socket, std::int64_t tick, const std::function<void(std::int64_t)>& answer) {
  using Clock = std::chrono::steady_clock;
  const auto quiet = std::chrono::milliseconds{300};
  int last = 0;
  for (Clock::time_point since = Clock::now(); Clock::now() - since < quiet;) {
    if (const int now = unread(socket); now > last) {
      last = now;
      answer(++tick);
      since = Clock::now();
    } else {
      ::usleep(200);
    }
  }
  return tick;
}

/// Never reads more than lets the host write its next tick, and that only after `hold` each time.
inline void keep_full(int socket, std::int64_t tick, std::chrono::milliseconds hold,
                      const std::function<void(std::int64_t)>& answer) {
  tick = fill_up(socket, tick, answer);
  for (int round = 0; round < 100; ++round) {
    std::this_thread::sleep_for(hold);
    const int before = unread(socket);
    std::array<char, 512> some{};
    for (ssize_t taken = 0; unread(socket) <= before - taken;) {
      const ssize_t count = ::recv(socket, some.data(), some.size(), MSG_DONTWAIT);
      if (count == 0) return;
      if (count > 0) taken += count;
      ::usleep(2000);
    }
    answer(++tick);
  }
}

}  // namespace fakes

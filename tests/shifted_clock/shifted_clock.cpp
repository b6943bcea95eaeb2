// Preloaded by scripts/attack (row "clocks"): the wall clock of a program jumps by hours, back and forth,
// every 0.1 s. All processes see the same jumps, since these are a function of the steady clock, which is
// left as it is.

#include <sys/syscall.h>
#include <sys/time.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <ctime>

namespace {

constexpr std::int64_t step_ms = 100;

std::int64_t setting(const char* name, std::int64_t usual) {
  const char* text = std::getenv(name);
  return text == nullptr ? usual : std::strtoll(text, nullptr, 10);
}

/// Past every cache and vDSO, which another library may have taken.
int true_time(clockid_t clock, timespec* time) {
  return static_cast<int>(::syscall(SYS_clock_gettime, clock, time));
}

/// splitmix64, Steele, Lea and Flood, "Fast splittable pseudorandom number generators", OOPSLA 2014.
std::uint64_t mixed(std::uint64_t value) {
  value += 0x9e3779b97f4a7c15;
  value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9;
  value = (value ^ (value >> 27)) * 0x94d049bb133111eb;
  return value ^ (value >> 31);
}

/// By how much the clock is wrong now [s].
std::int64_t shift() {
  static const std::int64_t hours = setting("SHIFTED_CLOCK_HOURS", 12);
  static const std::int64_t seed = setting("SHIFTED_CLOCK_SEED", 1);
  timespec steady{};
  true_time(CLOCK_MONOTONIC, &steady);
  const std::int64_t step = (steady.tv_sec * 1000 + steady.tv_nsec / 1'000'000) / step_ms;
  const std::uint64_t dice =
      mixed(static_cast<std::uint64_t>(seed) ^ mixed(static_cast<std::uint64_t>(step)));
  const std::int64_t span = 3600 * hours;
  return static_cast<std::int64_t>(dice % static_cast<std::uint64_t>(2 * span + 1)) - span;
}

}  // namespace

extern "C" {

int clock_gettime(clockid_t clock, timespec* time) noexcept {
  const int result = true_time(clock, time);
  const bool wall = clock == CLOCK_REALTIME || clock == CLOCK_REALTIME_COARSE || clock == CLOCK_TAI;
  if (result == 0 && wall) time->tv_sec += shift();
  return result;
}

int gettimeofday(timeval* time, void*) noexcept {
  timespec now{};
  clock_gettime(CLOCK_REALTIME, &now);
  time->tv_sec = now.tv_sec;
  time->tv_usec = now.tv_nsec / 1000;
  return 0;
}

std::time_t time(std::time_t* out) noexcept {
  timespec now{};
  clock_gettime(CLOCK_REALTIME, &now);
  if (out != nullptr) *out = now.tv_sec;
  return now.tv_sec;
}

int timespec_get(timespec* time, int base) noexcept {
  return clock_gettime(CLOCK_REALTIME, time) == 0 ? base : 0;
}
}

#include "experiments/host/patience.h"

#include <algorithm>
#include <sstream>

namespace host {
namespace {

using namespace std::chrono_literals;

// Between two looks at the team's processes: a look takes some 0.05 ms, and 0.1 s is little of 5 s (ours).
constexpr auto usual_interval = 100ms;

Patience::Clock::duration span(double seconds) {
  return std::chrono::round<Patience::Clock::duration>(std::chrono::duration<double>(seconds));
}
double seconds(Patience::Clock::duration span) { return std::chrono::duration<double>(span).count(); }

std::string text(double seconds) {
  std::ostringstream text;
  text.precision(3);
  text << seconds << " s";
  return text.str();
}

}  // namespace

void Patience::begin(std::chrono::milliseconds allowed, Clock::time_point now) {
  active_ = true;
  allowed_ = allowed;
  begin_ = seen_ = now;
  passed_ = owed_ = used_ = {};
  known_ = false;
}

void Patience::count(Clock::time_point now, const Look& look) {
  if (!active_) return;
  const Clock::duration interval = std::min<Clock::duration>(usual_interval, allowed_ / 10);
  const Clock::duration passed = now - seen_;
  if (passed < interval) return;
  seen_ = now;
  // We look every 10 ms: when it was much longer, we did not run ourselves.
  const Clock::duration counts = std::min(passed, 2 * interval);
  const TeamTime time = look();
  passed_ += counts;
  if (known_) {
    const Clock::duration owed = span(time.delay_seconds - last_.delay_seconds);
    owed_ += counts < passed ? std::min(owed, counts) : owed;
    const double used =
        std::max(time.processor_seconds - last_.processor_seconds, time.used_seconds - last_.used_seconds);
    used_ += std::clamp(span(used), Clock::duration::zero(), counts);
  } else {
    used_ += counts;
  }
  known_ = true;
  last_ = time;
}

bool Patience::machine_is_too_slow() const {
  return !is_over() && seen_ - begin_ >= std::max<Clock::duration>(longest * allowed_, at_least);
}

std::string Patience::within() const {
  const std::string allowed = " within " + text(seconds(allowed_));
  const Clock::duration clock = seen_ - begin_;
  if (clock < allowed_ + allowed_ / 2) return allowed;
  return allowed + " of its own time, " + text(seconds(clock)) + " by the clock: it was kept waiting";
}

std::string Patience::starved() const {
  return "in " + text(seconds(seen_ - begin_)) + " it could use only " + text(seconds(own()));
}

}  // namespace host

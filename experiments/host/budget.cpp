#include "experiments/host/budget.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace host {
namespace {

using namespace std::chrono_literals;

// A look takes some 0.1 ms for both teams, a game 5 to 10 s: once a second is nothing (ours).
constexpr std::chrono::milliseconds usual_interval = 1s;
// Of what is allowed may pass unseen at the end (ours).
constexpr int looks_in_a_budget = 20;
// The kernel counts processor time of a process in steps of 10 ms.
constexpr std::chrono::milliseconds least_interval = 20ms;

double seconds(Budget::Clock::duration span) { return std::chrono::duration<double>(span).count(); }

/// "21.3 s", "1440.2 s"
std::string text(double seconds) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), seconds < 100 ? "%.3g s" : "%.1f s", seconds);
  return text.data();
}
std::string text(std::chrono::milliseconds span) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%g s", seconds(span));
  return text.data();
}

/// [s] of threads and children that have ended.
double ended(const TeamTime& team) { return team.processor_seconds - team.living_seconds; }

}  // namespace

void Budget::begin(Allowed allowed, Clock::time_point now, const TeamTime& team, double host_delay) {
  *this = {};
  begun_ = true;
  allowed_ = allowed;
  interval_ = usual_interval;
  for (const std::chrono::milliseconds span : {allowed.second, allowed.game}) {
    if (span > 0ms) interval_ = std::min<Clock::duration>(interval_, span / looks_in_a_budget);
  }
  interval_ = std::max<Clock::duration>(interval_, least_interval);
  mark_ = looked_ = second_began_ = now;
  last_ = team;
  host_delay_ = host_delay;
  processor_at_begin_ = team.processor_seconds;
  ended_at_begin_ = ended(team);
}

void Budget::begin_second(std::int64_t number, Clock::time_point now) {
  second_ = number;
  second_began_ = now;
  own_second_ = 0;
}

void Budget::look(Clock::time_point now, const TeamTime& team, double host_delay) {
  if (!begun_ || now <= looked_) return;
  count_wait(now);
  const double own = own_since_last_look(team, host_delay);
  // The look before may have been in an earlier second.
  const double share = seconds(now - second_began_) / seconds(now - looked_);
  own_second_ += std::clamp(share, 0.0, 1.0) * own;
  own_game_ += own;
  looked_ = now;
  waited_ = {};
  last_ = team;
  host_delay_ = host_delay;
}

double Budget::own_since_last_look(const TeamTime& team, double host_delay) {
  const double used = team.processor_seconds - processor_at_begin_;
  // Delays of threads that have ended are not known. 0.05 s: the steps in which processor time is counted.
  const bool exact = team.delays_known && team.living_seconds >= last_.living_seconds &&
                     ended(team) - ended_at_begin_ < 0.05 + 0.05 * used;
  const double processor = exact ? team.living_seconds - last_.living_seconds
                                 : std::max(0.0, team.processor_seconds - last_.processor_seconds);
  double slept = 0;  // and computed, while it was waited for
  if (exact) {
    const double delays = team.delay_seconds - last_.delay_seconds + std::max(0.0, host_delay - host_delay_);
    slept = seconds(waited_) - delays;
  } else if (waiting_ && !team.wants_machine) {
    slept = seconds(waited_);  // it was seen asleep
  }
  return std::max(processor, slept);
}

std::string Budget::excess() const {
  const auto sentence = [](double used, const std::string& what, std::chrono::milliseconds allowed) {
    return "used " + text(used) + " of its own time for " + what + ", " + text(allowed) + " are allowed";
  };
  if (allowed_.second > 0ms && own_second_ > seconds(allowed_.second)) {
    return sentence(own_second_, "simulated second " + std::to_string(second_), allowed_.second);
  }
  if (allowed_.game > 0ms && own_game_ > seconds(allowed_.game)) {
    return sentence(own_game_, "the game up to simulated second " + std::to_string(second_), allowed_.game);
  }
  return "";
}

}  // namespace host

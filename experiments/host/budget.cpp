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
// Of what is allowed, for what may be its own time. Ours: with 20 s for a second, and 20 s of waits for the
// disk, it ends before the 60 s after which a runner takes a game for stuck.
constexpr double unclear_share = 1.5;

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
  own_second_ = unclear_second_ = 0;
}

void Budget::look(Clock::time_point now, const TeamTime& team, double host_delay) {
  if (!begun_ || now <= looked_) return;
  count_wait(now);
  const Spent spent = since_last_look(team, host_delay);
  // The look before may have been in an earlier second.
  const double share = std::clamp(seconds(now - second_began_) / seconds(now - looked_), 0.0, 1.0);
  own_second_ += share * spent.own;
  own_game_ += spent.own;
  unclear_second_ += share * spent.unclear;
  unclear_game_ += spent.unclear;
  looked_ = now;
  waited_ = {};
  last_ = team;
  host_delay_ = host_delay;
}

Budget::Spent Budget::since_last_look(const TeamTime& team, double host_delay) const {
  const double used = team.processor_seconds - processor_at_begin_;
  // Delays of threads that have ended are not known. 0.05 s: the steps in which processor time is counted.
  const bool exact = team.delays_known && team.living_seconds >= last_.living_seconds &&
                     ended(team) - ended_at_begin_ < 0.05 + 0.05 * used;
  const double processor = exact ? team.living_seconds - last_.living_seconds
                                 : std::max({0.0, team.processor_seconds - last_.processor_seconds,
                                             team.used_seconds - last_.used_seconds});
  const double delays = team.delay_seconds - last_.delay_seconds + std::max(0.0, host_delay - host_delay_);
  const double slept = seconds(waited_) - delays;  // and computed, while it was waited for
  if (exact) return {std::max(processor, slept), 0};
  if (waiting_ && !team.wants_machine) return {std::max(processor, seconds(waited_)), 0};  // seen asleep
  return {processor, std::max(0.0, slept - processor)};
}

std::string Budget::excess() const {
  const auto sentence = [](double own, double unclear, const std::string& what,
                           std::chrono::milliseconds allowed) -> std::string {
    if (allowed == 0ms) return "";
    const std::string limit = ", " + text(allowed) + " are allowed";
    if (own > seconds(allowed)) return "used " + text(own) + " of its own time for " + what + limit;
    if (own + unclear <= unclear_share * seconds(allowed)) return "";
    return "was waited for " + text(own + unclear) + " for " + what +
           ", with threads or children that end all the time, so that its own time cannot be told from the "
           "machine's" +
           limit;
  };
  const std::string number = std::to_string(second_);
  const std::string second =
      sentence(own_second_, unclear_second_, "simulated second " + number, allowed_.second);
  if (!second.empty()) return second;
  return sentence(own_game_, unclear_game_, "the game up to simulated second " + number, allowed_.game);
}

}  // namespace host

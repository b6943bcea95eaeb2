#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include "experiments/host/team_time.h"

namespace host {

/// How much of its own time a team may use: its processor time, or the time for which it lets the host wait
/// less what the machine owes it (TeamClock), whichever is more.
///
/// Patience (patience.h) is for one reply; this is for the sum of all replies of a simulated second and of a
/// game, however short each of them. While all is well it costs a look at the clock per reply. Once a second,
/// and more often when less is allowed, the team's processes are looked at: what they waited for a processor,
/// and what the host itself did, is the machine's delay or the other team's work and does not count. Of threads
/// and children that end all the time nobody knows their delays: of a team that has such, what it is waited
/// for and does not compute counts only when it makes half as much again as is allowed.
class Budget {
 public:
  using Clock = std::chrono::steady_clock;

  /// 0: any amount.
  struct Allowed {
    std::chrono::milliseconds second{};  ///< for a simulated second
    std::chrono::milliseconds game{};    ///< for a game, from its first tick on
  };

  /// The first tick is about to be sent.
  /// @param team        what its processes have done so far
  /// @param host_delay  [s] for which the host has wanted a processor and had none so far
  void begin(Allowed allowed, Clock::time_point now, const TeamTime& team, double host_delay);
  /// The next simulated second begins; they are counted from 1.
  void begin_second(std::int64_t number, Clock::time_point now);

  // A tick. Without begin() nothing is counted.
  void sent(Clock::time_point now) {
    waiting_ = true;
    mark_ = now;
  }
  void answered(Clock::time_point now) {
    count_wait(now);
    waiting_ = false;
  }
  /// It was the other team that was waited for until then.
  void wait_only_from(Clock::time_point time) {
    if (waiting_ && time > mark_) mark_ = time;
  }
  /// To be called every 10 ms or so while waiting.
  void count_wait(Clock::time_point now) {
    if (waiting_) waited_ += now - mark_ < longest_step ? now - mark_ : longest_step;
    mark_ = now;
  }
  bool waiting() const { return waiting_; }
  Clock::time_point mark() const { return mark_; }  ///< the last of the moments above

  bool wants_look(Clock::time_point now) const { return begun_ && now - looked_ >= interval_; }
  /// The parameters are those of begin().
  void look(Clock::time_point now, const TeamTime& team, double host_delay);

  /// "used 21.3 s of its own time for simulated second 14, 20 s are allowed"; empty while it has enough.
  std::string excess() const;
  /// [s] in this game, up to the last look.
  double own_seconds() const { return own_game_; }

 private:
  // We look at the channel every 10 ms: when it was much longer, we did not run ourselves.
  static constexpr std::chrono::milliseconds longest_step{20};

  struct Spent {
    double own = 0;      ///< [s]
    double unclear = 0;  ///< [s] besides: its own or the machine's
  };
  Spent since_last_look(const TeamTime& team, double host_delay) const;

  Allowed allowed_;
  bool begun_ = false;
  bool waiting_ = false;
  Clock::duration interval_{};  ///< between two looks
  Clock::time_point mark_{};
  Clock::duration waited_{};    ///< for it since the last look
  Clock::time_point looked_{};  ///< the last look
  Clock::time_point second_began_{};
  std::int64_t second_ = 1;
  double own_second_ = 0;      ///< [s]
  double own_game_ = 0;        ///< [s]
  double unclear_second_ = 0;  ///< [s]
  double unclear_game_ = 0;    ///< [s]
  TeamTime last_;
  double host_delay_ = 0;          ///< [s] at the last look
  double processor_at_begin_ = 0;  ///< [s]
  double ended_at_begin_ = 0;      ///< [s] of threads and children that had ended
};

}  // namespace host

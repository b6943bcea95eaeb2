#pragma once

#include <algorithm>
#include <chrono>
#include <functional>
#include <string>

#include "experiments/host/team_time.h"

namespace host {

/// How long a team may take for something, in its own time: what the machine owes it (TeamClock) does not
/// count, nor the time for which the host itself stands still.
///
/// So a good team is not blamed for a machine under load or one that was suspended,
/// and a team that is silent on a quiet machine has exactly the time allowed. Looked at every 0.1 s;
/// a team that answers sooner costs nothing.
class Patience {
 public:
  using Clock = std::chrono::steady_clock;
  using Look = std::function<TeamTime()>;
  // So many times the time allowed may pass on the clock, and at least so long; then it is the machine's
  // fault. Ours: 30 s for a reply is below the minute after which a runner takes a game for stuck.
  static constexpr int longest = 6;
  static constexpr std::chrono::seconds at_least{30};

  /// The team's time begins.
  void begin(std::chrono::milliseconds allowed, Clock::time_point now);
  /// It has done what it should.
  void end() { active_ = false; }

  /// To be called every 10 ms or so while waiting.
  /// @param look  at what the team does; asked for every 0.1 s at most
  void count(Clock::time_point now, const Look& look);

  bool is_over() const { return own() >= allowed_; }
  /// It has hardly been able to do anything, for much longer than allowed.
  bool machine_is_too_slow() const;

  /// " within 5 s", and how long it was on the clock when that is much more.
  std::string within() const;
  /// "in 30 s it could use only 0.4 s"
  std::string starved() const;

 private:
  // Of a short wait we know only when it is over, perhaps a look later: hence by sums.
  Clock::duration own() const { return std::max(passed_ - owed_, used_); }

  bool active_ = false;
  Clock::duration allowed_{};
  Clock::time_point begin_{};
  Clock::time_point seen_{};  ///< the last look
  Clock::duration passed_{};  ///< while the host ran
  Clock::duration owed_{};    ///< of that, by the machine
  Clock::duration used_{};    ///< on processors, no more than has passed
  bool known_ = false;        ///< the next one is of this waiting
  TeamTime last_;             ///< what that was
};

}  // namespace host

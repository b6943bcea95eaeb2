#pragma once

#include "autoref/referee/referee.h"
#include "experiments/record/match_record.h"

namespace host {

/// Keeps the books of a game: timeline, calls by event, fouls, stoppages, ball in play.
class Tally {
 public:
  /// One tick, after the referee's update.
  /// @return the entries it added to the timeline, valid until the next call
  std::span<const record::CallEntry> add(const referee::Output& output, const referee::Referee& referee);

  /// Writes what was counted into the record.
  void finish(const referee::Referee& referee, record::MatchRecord& record);

 private:
  void add(const referee::Call& call);

  record::MatchRecord counted_;
  world::Location location_ = world::Location::Init;
  std::int64_t ticks_ = 0;
  std::int64_t ticks_in_play_ = 0;
};

/// "BallLeftFieldTouchLine" and so on; the offences of a kick by their own names.
std::string name(const world::GameEvent& event);

}  // namespace host

#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/record/match_statistics.h"
#include "sim/world/robot_id.h"
#include "sim/world/time.h"

namespace record {

/// How a game ended. What it means for the result is decided together with the party at fault.
enum class Termination : std::uint8_t {
  Finished,       ///< the referee reached POST
  NotStarted,     ///< a team's program could not be started
  NotConnected,   ///< it ran but did not connect in time
  Crashed,        ///< it ended by a signal or with a non-zero exit code
  Closed,         ///< it closed the channel, or ended with exit code 0, before the game was over
  NotResponding,  ///< no reply in time
  Nonsense,       ///< it sent something that is not a valid message
  Overlong,       ///< over 40 simulated minutes: the referee is stuck (harness)
  Interrupted,    ///< stopped by the user (harness)
  HarnessFault,   ///< anything else that no team did
  OverLimit,      ///< it used more memory or time, or printed more, than a team may
  /// over, but no game: nobody moved, robots were missing, or nothing was in play (harness)
  Implausible,
  StoodStill  ///< over, and the other team moved, but it never did
};

/// Who is to blame when a game did not finish.
enum class Party : std::uint8_t { Nobody, Yellow, Blue, Both, Harness };

/// What an end means for the tables: the two wins and the draw count, a void game is played again.
enum class Outcome : std::uint8_t { YellowWins, BlueWins, Draw, Void };

constexpr Party party(world::Team team) { return team == world::Team::Yellow ? Party::Yellow : Party::Blue; }

const char* name(Termination termination);  ///< "finished", "not-connected", ...
const char* name(Party party);              ///< "nobody", "yellow", ...
const char* name(Outcome outcome);          ///< "yellow-wins", ...

/// @throws std::invalid_argument naming the word and the known ones
Termination termination_from_name(std::string_view word);
Party party_from_name(std::string_view word);
Outcome outcome_from_name(std::string_view word);

/// One decision of the referee.
struct CallEntry {
  world::Time time;        ///< match time of the occurrence
  std::string row;         ///< transition in the paper's tables, "T11.7"
  std::string event;       ///< what happened, "BallLeftFieldTouchLine"; empty: no event
  std::string command;     ///< what was sent, "STOP", "INDIRECT yellow"; empty: nothing
  std::string restart;     ///< what the game restarts with; empty: nothing
  std::string sentence;    ///< all of it for a reader
  std::string evidence{};  ///< the long record as JSON, for printing only: not kept in any ledger
  bool operator==(const CallEntry&) const = default;
};

/// What one attempt at one game gave.
struct MatchRecord {
  world::PerTeam<int> goals;  ///< as played, before any forfeit
  Termination termination = Termination::HarnessFault;
  Party at_fault = Party::Harness;
  std::string reason;  ///< one sentence; empty when finished

  std::int64_t ticks = 0;            ///< simulated
  std::string hash;                  ///< XXH3-128 of the game, 32 hexadecimal digits
  std::map<std::string, int> calls;  ///< number of the referee's calls by event
  world::PerTeam<int> fouls{};       ///< offences called against each team
  world::PerTeam<std::map<std::string, int>> fouls_by_kind{};  ///< the same by event
  int stoppages = 0;                            ///< times the game left GAME_ON, goals included
  std::map<std::string, double> counters;       ///< anything else that is counted, same for the same game
  std::optional<MatchStatistics> statistics{};  ///< from the truth; ledgers before schema 2 have none
  world::PerTeam<std::string> versions;         ///< what the team's program says it is
  std::vector<CallEntry> timeline;

  double wall_seconds = 0;              ///< not part of the result
  std::map<std::string, double> costs;  ///< times and memory, not part of the result
  bool operator==(const MatchRecord&) const = default;
};

/// The record as one line of JSON.
std::string to_json(const MatchRecord& record);

/// Whether the timeline of a record is read: it is nine tenths of a full game's.
enum class Timeline { Read, Skip };

/// @throws std::invalid_argument naming the field when `text` is not such a line, or a number in it
///         is out of its range
MatchRecord match_record_from_json(const std::string& text, Timeline timeline = Timeline::Read);

/// Who won: by goals when finished, against the team at fault otherwise; void when both or the harness are.
Outcome outcome(const MatchRecord& record);

/// The goals that count: as played, or 0 to `forfeit_goals` against the team at fault.
world::PerTeam<int> counted_goals(const MatchRecord& record, int forfeit_goals);

}  // namespace record

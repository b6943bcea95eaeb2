#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sim/world/field.h"
#include "sim/world/robot_id.h"
#include "sim/world/time.h"
#include "sim/world/tracked_frame.h"

namespace world {

/// Where the game is, as the paper's automaton names it (Table 3, and INIT of Table 10).
enum class Location : std::uint8_t { Init, GameOn, GameOff, Setup, Break };

/// The paper's coarse stages (Table 5), and those of a game that needs a winner (laws of 2015, appendix A).
enum class Stage : std::uint8_t {
  PreFirst,
  First,
  HalfTime,
  PreSecond,
  Second,
  ExtraBreak,
  PreExtraFirst,
  ExtraFirst,
  ExtraHalfTime,
  PreExtraSecond,
  ExtraSecond,
  ShootoutBreak,
  Shootout,
  Post
};

/// The paper's referee commands (Table 1, with PENALTY and TIMEOUT of the appendix).
enum class CommandKind : std::uint8_t {
  Halt,
  Stop,
  Indirect,
  Direct,
  Kickoff,
  Penalty,
  Goal,
  Ready,
  Start,
  Timeout
};

/// A command as sent to the teams; `team` says nothing for HALT, STOP, READY and START.
struct Command {
  CommandKind kind = CommandKind::Halt;
  Team team = Team::Yellow;
};

constexpr bool has_team(CommandKind kind) {
  return kind != CommandKind::Halt && kind != CommandKind::Stop && kind != CommandKind::Ready &&
         kind != CommandKind::Start;
}
constexpr bool operator==(const Command& a, const Command& b) {
  return a.kind == b.kind && (!has_team(a.kind) || a.team == b.team);
}

const char* name(Location location);
const char* name(Stage stage);
const char* name(CommandKind kind);

/// A penalty kick from the moment it was taken until it is decided (laws of 2015, Law 14).
struct PenaltyKick {
  Time taken;
  std::optional<RobotId> attacker{};  ///< who of the kicking team was where it must not be
  std::optional<RobotId> defender{};  ///< who of the others
};

/// The automaton's location and variables: the paper's Table 6 with the additions of its appendix.
struct GameState {
  Location location = Location::Init;
  Stage stage = Stage::PreFirst;
  Time time;
  std::optional<Time> stage_end;           ///< nothing in the PRE stages and POST
  PerTeam<Duration> timeout_time{};        ///< left
  PerTeam<int> timeout_num{};              ///< left
  std::optional<Team> timeout_team;        ///< only during a time-out
  std::optional<Vector2d> reset_position;  ///< [m] where the ball is to be placed
  std::optional<Time> kick_deadline;
  CommandKind call = CommandKind::Stop;        ///< to be transmitted next
  CommandKind restart = CommandKind::Kickoff;  ///< what the stoppage is for; a retake repeats it
  std::optional<Team> touch_team;              ///< last team to touch the ball in play
  std::optional<Touch> last_touch;             ///< the touch that set it
  Team kick_team = Team::Yellow;
  bool goal_allowed = true;
  bool is_kickoff = false;
  std::optional<RobotId> kicker;          ///< who took the free kick, until another robot touches the ball
  std::optional<Vector2d> kick_position;  ///< [m] ball when the present restart was signalled
  PerTeam<int> red_cards{};
  PerTeam<std::vector<Duration>> yellow_times{};  ///< remaining time of each card
  PerTeam<int> yellow_cards{};                    ///< ever shown
  std::optional<PenaltyKick> penalty;             ///< while it is not decided
  PerTeam<int> shootout_kicks{};                  ///< taken in the shoot-out
  PerTeam<int> shootout_goals{};                  ///< scored in it; they count in `score` too
  bool halted = false;  ///< paused, in BREAK: by the operator, or because nothing is seen

  // What the paper takes as given.
  Team first_kickoff = Team::Yellow;
  bool blue_on_positive_half = true;  ///< blue defends the goal at +x
  PerTeam<int> score{};
  PerTeam<int> keeper{};  ///< robot number
  Command command;        ///< transmitted last
  std::uint32_t command_counter = 0;
  Time command_time;
  Time location_time;  ///< when the present location was entered
};

/// The goal a team defends.
constexpr Side defended_side(const GameState& state, Team team) {
  return ((team == Team::Blue) == state.blue_on_positive_half) ? Side::Positive : Side::Negative;
}
constexpr Team defending_team(const GameState& state, Side side) {
  return defended_side(state, Team::Blue) == side ? Team::Blue : Team::Yellow;
}

}  // namespace world

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/truth/truth.h"
#include "sim/world/game_state.h"
#include "sim/world/referee_message.h"
#include "sim/world/robot_command.h"

namespace host {

/// Signs that a game was one: both teams moved, the robots that may play were there, the referee was heard.
///
/// A game in which a team's program runs but controls nothing ends 0:0 like any other and would count;
/// harness reviews found such games in published tables. Where one team alone stood still it is its own
/// doing: in the same simulator, under the same referee, the other one moved. A void game would be a way out
/// of a pair that it may lose.
class Vitals {
 public:
  // Numbers of ours.
  static constexpr double least_way = 0.3;  ///< [m] from the first place: three robot radii, no mere push
  /// [s] of GAME_OFF in a row, where cards are acted on at once (robot_count.h);
  /// coming back may have to wait for room
  static constexpr int longest_miscount = 10;

  /// What is missing, and by whom.
  struct Complaint {
    std::string sentence;  ///< without a subject when a team is to blame; empty: nothing is missing
    std::optional<world::Team> team;  ///< whose fault it is; nothing: no team's
  };

  /// Every tick: what the teams tell their robots, and whether the ball is in play.
  void note(const world::PerTeam<world::TeamCommands>& commands, const world::GameState& state);

  /// Once a simulated second: where the robots are, and what the referee says.
  void add(const truth::Frame& truth, const world::RefereeMessage& message, const world::GameState& state);

  /// Of a game that is over.
  Complaint complaint() const;

 private:
  void count(const truth::Frame& truth, const world::RefereeMessage& message);
  std::string stillness(world::Team team) const;  // how it stood still; empty: it did not

  std::vector<truth::Robot> first_;   ///< robots at the first look
  world::PerTeam<double> way_{};      ///< [m] the furthest any robot was from its first place
  world::PerTeam<bool> commanded_{};  ///< some robot was told to move
  world::PerTeam<int> miscounts_{};   ///< looks in a row
  std::string miscount_;              ///< the first that lasted too long
  std::uint32_t first_command_ = 0;   ///< the referee's counter at the first look
  bool heard_ = false;                ///< it has given a command since
  bool started_ = false;              ///< it has ordered a start
  bool in_play_ = false;
};

}  // namespace host

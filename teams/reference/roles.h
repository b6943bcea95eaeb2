#pragma once

#include <array>
#include <optional>

#include "teams/reference/defense.h"
#include "teams/reference/parameters.h"
#include "teams/reference/situation.h"

namespace reference {

enum class Role : std::uint8_t { None, Goalie, Winner, Support, Defender };
const char* name(Role role);

/// How many field players do what, beside one goalie and one ball winner.
struct Formation {
  int winners = 0;
  int defenders = 0;
  int supports = 0;
};

/// For `field_players` robots without the goalie: fewer defenders when we have the ball in their half, more
/// when they have it in ours (reference "football", 2.8).
Formation formation(int field_players, Possession possession, double ball_x, const Parameters& parameters);

/// Who does what, by robot number.
struct Roles {
  std::array<Role, world::max_robot_number + 1> role{};
  /// Of supports: from right (-y) to left. Of defenders: the task in `defense`.
  std::array<int, world::max_robot_number + 1> index{};
  int goalie = -1;
  int winner = -1;  ///< with one robot in all: the goalie
  Formation formation;
  DefensePlan defense;

  Role of(int number) const { return role[static_cast<std::size_t>(number)]; }
};

/// Gives out the roles of one tick.
///
/// The goalie is the referee's keeper, or the lowest number when it is not there. The winner is the robot
/// that reaches the ball first, with 0.15 s in favour of the one before; `receiver` is the winner as long as
/// it is given. The tasks of the defence go to the rest so that the sum of their travel times is least, 0.2 s
/// in favour of who had the task before; those left over support. Defence is planned anew at 10 Hz and
/// whenever winner, goalie or formation change.
Roles assign_roles(const kit::View& view, const Situation& situation, const Roles& before,
                   Formation formation, std::optional<int> receiver);

/// The goalie of this tick, or -1 without robots.
int goalie_of(const kit::View& view);

}  // namespace reference

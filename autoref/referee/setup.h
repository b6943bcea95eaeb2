#pragma once

#include <string>
#include <string_view>

#include "sim/world/field.h"
#include "sim/world/robot_id.h"
#include "sim/world/rules/rule_set.h"

namespace referee {

/// What the referee is told before the first frame.
struct Setup {
  world::RuleSet rules = world::rule_set("ssl-2015");
  world::Geometry geometry;  ///< its field replaces the one of the rule set
  bool blue_on_positive_half = true;
  world::Team first_kickoff = world::Team::Yellow;
  world::PerTeam<int> keeper{};  ///< robot numbers
  world::PerTeam<std::string> names{};
  world::PerTeam<int> robots{6, 6};  ///< allowed on the field before any card
  bool explain = false;              ///< fill Call::evidence; changes no call
};

/// What a log must say beside the referee message's own fields so that the game can be refereed again:
/// "rules=ssl-2015 half_length=600 first_kickoff=yellow robots=6,6" (half length in s, robots yellow,blue),
/// and "winner=yes extra_half_length=300" for a game that needs a winner.
std::string setup_text(const Setup& setup);

/// The same read back: rule set, lengths, first kickoff, robots and winner;
/// everything else as in a default Setup.
///
/// @throws std::invalid_argument naming the word that cannot be read
Setup parse_setup(std::string_view text);

}  // namespace referee

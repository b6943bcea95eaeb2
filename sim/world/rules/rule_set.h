#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sim/world/field.h"
#include "sim/world/time.h"

namespace world {

/// Which touch algorithms vote (the paper's of 6.5.2, and ours); a touch is reported when any of them sees
/// one.
struct TouchAlgorithms {
  bool accel = false;
  bool line = false;
  bool backtrack = false;
  bool reach = false;       ///< ours: a ball carried at the dribbler, which the three above do not see
  bool likelihood = false;  ///< ours: contact against free motion, with a probability; made to vote alone
  bool as_coded =
      false;  ///< line and backtrack with the tests of the authors' code (requirements I-23, I-24)
};

/// Every limit, distance, time and dimension the referee uses. A rule set is a value of this type in a file
/// of its own.
struct RuleSet {
  std::string name;
  Field field;
  int robots_per_team = 6;

  // The clock.
  Duration half_length = std::chrono::minutes{10};
  Duration half_time = std::chrono::seconds{0};      ///< simulated games do not wait
  Duration half_overrun = std::chrono::seconds{60};  ///< then the half is ended without a stoppage
  Duration kick_time = std::chrono::seconds{10};     ///< to take a kick
  int timeouts = 4;
  Duration timeout_time = std::chrono::minutes{5};
  Duration yellow_card = std::chrono::minutes{2};

  // Stoppages.
  double stop_speed = 1.5;           ///< [m/s]
  double stop_distance = 0.5;        ///< [m] hull to ball
  double ball_settled_speed = 0.1;   ///< [m/s] V_b of Algorithm 3
  double robot_settled_speed = 0.4;  ///< [m/s] V_r of Algorithm 3
  Duration settled_for = std::chrono::seconds{1};
  Duration settle_limit = std::chrono::seconds{15};  ///< then play is restarted anyway
  double placement_tolerance = 0.05;                 ///< [m] ball to reset position
  Duration reset_retry = std::chrono::seconds{1};

  // Kicks.
  double kick_travel = 0.05;            ///< [m] the ball is in play; the kicker may not touch it again
  double opponent_distance = 0.5;       ///< [m] hull to ball at a restart
  double attacker_area_distance = 0.2;  ///< [m] hull to the opponents' defense area at a restart
  bool retake_keeps_call =
      true;  ///< encroachment: the same kick again; false: always indirect, as printed in Table 18

  // Play.
  int exit_frames = 3;            ///< consecutive frames outside (Algorithm 2)
  double touch_line_inset = 0.1;  ///< [m] kick-in
  double corner_inset = 0.1;      ///< [m] from both lines
  double goal_kick_inset = 0.5;   ///< [m] from the goal line
  bool direct_from_goal_line =
      true;  ///< corner and goal kick are direct; false: always indirect, as in Algorithm 2
  double max_ball_speed = 8.0;   ///< [m/s]
  double max_dribble = 1.0;      ///< [m] straight
  double stuck_distance = 0.25;  ///< [m] in one second
  Duration stuck_time = std::chrono::seconds{12};
  double free_kick_area_distance = 0.7;  ///< [m] attackers' free kicks from the opponents' defense area
  double free_kick_goal_line = 0.6;      ///< [m] free kicks inside a defense area: from the goal line
  TouchAlgorithms touch{.likelihood = true};
};

/// The rule set of that name.
///
/// @throws std::invalid_argument naming the known ones
const RuleSet& rule_set(std::string_view name);

std::vector<std::string_view> rule_set_names();

}  // namespace world

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sim/world/field.h"
#include "sim/world/time.h"

namespace world {

/// Which touch algorithms vote (the paper's of 6.5.2, and ours); a touch is reported
/// when any of them sees one.
struct TouchAlgorithms {
  bool accel = false;
  bool line = false;
  bool backtrack = false;
  bool reach = false;       ///< ours: a ball carried at the dribbler, which the three above do not see
  bool likelihood = false;  ///< ours: contact against free motion, with a probability; made to vote alone
  /// line and backtrack with the tests of the authors' code (requirements I-23, I-24)
  bool as_coded = false;
};

/// Every limit, distance, time and dimension the referee uses. A rule set is a value of this
/// type in a file of its own.
struct RuleSet {
  std::string name;
  Field field;
  std::vector<std::string_view> detectors;  ///< those that run, by their names in the referee's catalogue
  bool chip_model = true;  ///< the filter may understand a ball as flying; false: it is taken to roll
  int robots_per_team = 6;

  // The clock.
  Duration half_length = std::chrono::minutes{10};
  Duration half_time = std::chrono::seconds{0};      ///< simulated games do not wait
  Duration half_overrun = std::chrono::seconds{60};  ///< then the half is ended without a stoppage
  Duration kick_time = std::chrono::seconds{10};     ///< to take a kick
  int timeouts = 4;
  Duration timeout_time = std::chrono::minutes{5};
  Duration yellow_card = std::chrono::minutes{2};
  Duration vision_timeout = std::chrono::seconds{2};  ///< nothing seen for so long: HALT

  // A game that needs a winner.
  bool winner = false;  ///< a draw is followed by extra time, and that by a shoot-out
  Duration extra_break = std::chrono::seconds{0};
  Duration extra_half_length = std::chrono::minutes{5};
  Duration extra_half_time = std::chrono::seconds{0};
  int extra_timeouts = 2;
  Duration extra_timeout_time = std::chrono::minutes{5};
  Duration shootout_break = std::chrono::seconds{0};
  int shootout_kicks = 5;   ///< of each team, before it goes on kick by kick
  int shootout_limit = 20;  ///< of each team; then the draw stays, so that every game ends
  int shootout_robots = 2;  ///< of each team on the field

  // Penalty kicks.
  double penalty_line = 0.4;  ///< [m] behind the mark: where all but kicker and keeper wait
  Duration penalty_time = std::chrono::seconds{10};  ///< from the kick: then it is decided

  // Stoppages.
  double stop_speed = 1.5;                        ///< [m/s]
  double stop_speed_margin = 0.1;                 ///< [m/s] allowed above it for the errors of the filter
  double stop_distance = 0.5;                     ///< [m] hull to ball
  double distance_margin = 0.02;                  ///< [m] every distance of a robot may be short by so much
  Duration stop_grace = std::chrono::seconds{2};  ///< before speeds and distances are watched
  Duration stop_violation = std::chrono::milliseconds{300};  ///< a speed must be too high for so long
  double ball_settled_speed = 0.1;                           ///< [m/s] V_b of Algorithm 3
  double robot_settled_speed = 0.4;                          ///< [m/s] V_r of Algorithm 3
  Duration settled_for = std::chrono::seconds{1};
  Duration settle_limit = std::chrono::seconds{15};  ///< then play is restarted anyway
  double placement_tolerance = 0.05;                 ///< [m] ball to reset position
  Duration reset_retry = std::chrono::seconds{1};

  // Kicks.
  double kick_travel = 0.05;            ///< [m] the ball is in play; the kicker may not touch it again
  double opponent_distance = 0.5;       ///< [m] hull to ball at a restart
  double attacker_area_distance = 0.2;  ///< [m] hull to the opponents' defense area at a restart
  /// encroachment: the same kick again; false: always indirect, as printed in Table 18
  bool retake_keeps_call = true;

  // Play.
  int exit_frames = 3;            ///< consecutive frames outside (Algorithm 2)
  int exit_frames_mouth = 6;      ///< the same for a way through the mouth of a goal
  int exit_frames_jump = 15;      ///< the same after a jump that no ball can make
  int exit_frames_hidden = 12;    ///< the same of a ball that a robot hides; 0: it must be seen
  double touch_line_inset = 0.1;  ///< [m] kick-in
  double corner_inset = 0.1;      ///< [m] from both lines
  double goal_kick_inset = 0.5;   ///< [m] from the goal line
  /// corner and goal kick are direct; false: always indirect, as in Algorithm 2
  bool direct_from_goal_line = true;
  double max_ball_speed = 8.0;   ///< [m/s]
  double max_dribble = 1.0;      ///< [m] straight
  double stuck_distance = 0.25;  ///< [m] in one second
  Duration stuck_time = std::chrono::seconds{12};
  double free_kick_area_distance = 0.7;  ///< [m] attackers' free kicks from the opponents' defense area
  double free_kick_goal_line = 0.6;      ///< [m] free kicks inside a defense area: from the goal line
  double icing_margin = 0.2;             ///< [m] behind the halfway line a kick must have been for icing
  double sure_touch = 0.8;               ///< least probability of a touch that is punished
  double chip_height = 0.15;             ///< [m] top of the ball; from there on a shot is no goal
  Duration chip_rolling = std::chrono::milliseconds{250};  ///< without flight: the ball has stopped bouncing
  double crash_speed = 1.5;             ///< [m/s] closing, along the line between the robots
  double crash_speed_difference = 0.3;  ///< [m/s] below it both robots are at fault
  double crash_braking = 0.3;           ///< [m/s] taken off for braking that the filter has not seen yet
  bool advantage = true;                ///< play goes on when the victim's team-mate has the ball
  Duration keeper_hold = std::chrono::seconds{15};
  double run_off = 0.25;                                  ///< [m] beyond the lines, where robots may drive
  Duration run_off_time = std::chrono::seconds{2};        ///< before a robot beyond it is noted
  Duration surplus_robot_time = std::chrono::seconds{2};  ///< before a robot too many is believed
  TouchAlgorithms touch{.likelihood = true};
};

/// Whether the rule set runs the detector of that name.
bool runs(const RuleSet& rules, std::string_view detector);

/// The rule set of that name.
///
/// @throws std::invalid_argument naming the known ones
const RuleSet& rule_set(std::string_view name);

std::vector<std::string_view> rule_set_names();

}  // namespace world

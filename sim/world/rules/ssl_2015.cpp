#include "sim/world/rules/ssl_2015.h"

namespace world {

RuleSet ssl_2015() {
  using namespace std::chrono_literals;
  RuleSet rules;
  rules.name = "ssl-2015";
  rules.field = Field{};      // Law 1
  rules.robots_per_team = 6;  // Law 3
  rules.detectors = {
      "ball touched",           // paper, 6.4
      "double touch",           // Law 9, decision 1
      "chip goal",              // Law 12, decision 7
      "ball too fast",          // Law 12, indirect free kicks
      "dribbled too far",       // Law 12, decision 5
      "collision",              // Law 12, direct free kicks, decisions 1 and 2
      "touched the goalie",     // Law 12, indirect free kicks
      "defender in own area",   // Law 12, penalty kick and caution 8
      "attacker in area",       // Law 12, indirect free kicks
      "goalie holds the ball",  // Law 12, indirect free kicks
      "icing",                  // Law 12, indirect free kicks
      "goal",                   // Law 10
      "ball left field",        // Law 9
      "no progress",            // Law 5
      "too many robots",        // Law 3
      "robot left field",       // Law 12, caution 7
      "kick taken",             // Laws 8, 9, 13, 15 to 17
      "robots settled",         // paper, Algorithm 3
      "too fast in stop",       // Law 12, caution 9
      "too near in stop",       // Laws 5 and 9
      "interfered placement",   // Law 9
  };
  rules.chip_model = true;    // Law 12, decision 7, needs heights
  rules.half_length = 10min;  // Law 7
  rules.half_time = 0s;       // Law 7 allows up to 5 min; nobody waits in a simulated game
  rules.half_overrun = 60s;   // ours: a half ends at a stoppage, but not later than this (I-18)
  rules.kick_time = 10s;      // Law 9
  rules.timeouts = 4;         // Law 7
  rules.timeout_time = 5min;  // Law 7
  rules.yellow_card = 2min;   // Law 12
  rules.vision_timeout = 2s;  // ours: 120 images of every camera; bursts of losses hide balls, not images
  rules.winner = false;       // appendix A: knock-out games only
  rules.extra_break = 0s;     // appendix A allows up to 5 min; as the half-time
  rules.extra_half_length = 5min;       // appendix A
  rules.extra_half_time = 0s;           // appendix A allows up to 2 min
  rules.extra_timeouts = 2;             // appendix A
  rules.extra_timeout_time = 5min;      // appendix A
  rules.shootout_break = 0s;            // appendix A allows up to 2 min
  rules.shootout_kicks = 5;             // appendix A
  rules.shootout_limit = 20;            // ours: appendix A knows no limit
  rules.shootout_robots = 2;            // appendix A
  rules.penalty_line = 0.4;             // Law 14
  rules.penalty_time = 10s;             // ours: Law 14 leaves the decision to the referee
  rules.stop_speed = 1.5;               // Law 12, caution 9
  rules.stop_speed_margin = 0.1;        // ER-Force's autoref
  rules.stop_distance = 0.5;            // Laws 5 and 9
  rules.distance_margin = 0.02;         // TIGERs' autoref; twice a camera's offset
  rules.stop_grace = 2s;                // TIGERs' and ER-Force's autorefs
  rules.stop_violation = 300ms;         // TIGERs' autoref
  rules.ball_settled_speed = 0.1;       // V_b of Algorithm 3: the authors' code
  rules.robot_settled_speed = 0.4;      // V_r of Algorithm 3: the authors' code
  rules.settled_for = 1s;               // Algorithm 3
  rules.settle_limit = 15s;             // Table 3, "or after some time has passed"; the authors' code
  rules.placement_tolerance = 0.05;     // ours: five times a camera's offset (I-16)
  rules.reset_retry = 1s;               // ours
  rules.kick_travel = 0.05;             // Law 9, decision 1
  rules.opponent_distance = 0.5;        // Laws 8, 13, 15, 16, 17
  rules.attacker_area_distance = 0.2;   // Law 9
  rules.retake_keeps_call = true;       // Law 13 (I-20, I-38)
  rules.exit_frames = 3;                // Algorithm 2
  rules.exit_frames_mouth = 6;          // ours: the filter runs through the goal's back wall first
  rules.exit_frames_jump = 15;          // ours: a quarter of a second, it is more likely a false ball
  rules.exit_frames_hidden = 12;        // ours: four times those in which it is seen
  rules.touch_line_inset = 0.1;         // Law 15
  rules.corner_inset = 0.1;             // Law 17
  rules.goal_kick_inset = 0.5;          // Law 16
  rules.direct_from_goal_line = true;   // Laws 16 and 17 (I-3)
  rules.max_ball_speed = 8.0;           // Law 12
  rules.max_dribble = 1.0;              // Law 12, decision 5
  rules.stuck_distance = 0.25;          // the authors' code
  rules.stuck_time = 12s;               // the authors' code
  rules.free_kick_area_distance = 0.7;  // Law 13
  rules.free_kick_goal_line = 0.6;      // Law 13
  rules.icing_margin = 0.2;             // TIGERs' autoref
  rules.sure_touch = 0.8;               // reference "football", 4.3
  rules.chip_height = 0.15;             // Law 12, decision 7
  rules.chip_rolling = 250ms;           // ours: a hop of 0.25 s is 75 mm high, which a filter sees
  rules.crash_speed = 1.5;              // laws since 2016 (2015 has no number), TIGERs, ER-Force
  rules.crash_speed_difference = 0.3;   // the same
  rules.crash_braking = 0.1;            // ours: 0.3 (ER-Force) made it 1.8 m/s and missed one in eight
  rules.advantage = true;               // Law 5; Law 12, decision 2
  rules.keeper_hold = 15s;              // Law 12
  rules.run_off = 0.25;                 // Law 1: the referee's walking area begins there
  rules.run_off_time = 2s;              // TIGERs' autoref, boundary crossing
  rules.surplus_robot_time = 2s;        // the game controller
  return rules;
}

}  // namespace world

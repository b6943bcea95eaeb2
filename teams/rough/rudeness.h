#pragma once

#include "teams/kit/flags.h"

namespace rough {

/// How rude the team is: for each habit the chance that it gives way to it when there is an opportunity.
/// All values ours, so that a game of 20 minutes shows each at least once or twice;
/// at 0 where the game would be another one.
struct Rudeness {
  double fast_kicks = 0.06;     ///< each kick: at 8 to 10 m/s
  double long_dribbles = 0.08;  ///< each time a robot gets the ball: carries it 1.6 m
  /// each time the ball is slow in or beside their own area: goes in and takes it
  double area_entries = 0.8;
  double area_attacks = 0.8;     ///< the same at the opponents' area
  double ramming = 0.008;        ///< each time an opponent comes within 1.2 m: full speed into it
  double encroachment = 0.008;   ///< each stoppage or kick of theirs and robot: stands 0.2 m from the ball
  double stop_speeding = 0.015;  ///< each stoppage and robot: drives as fast as it can
  double area_waiting = 0.03;    ///< each kick of ours and robot: waits at the edge of their area
  double wrong_half = 0.06;      ///< each kickoff and robot: steps over the halfway line
  double double_touches = 0.1;   ///< each free kick of ours: the kicker goes on with the ball
  double chips_at_goal = 0.6;    ///< each shot from 1 to 4 m: over everybody into the goal
  double chips_at_lines = 0.3;   ///< each kick within 0.8 m of a line: a chip along it
  double keeper_holding = 0.2;   ///< each time the goalie has the ball: keeps it for 17 s
  double keeper_neglect = 0;     ///< each time the ball comes within 0.5 m of the area: the goalie lets it be
  double slow_restarts = 0.04;   ///< each free kick of ours: not taken at all
  double goalie_feeding = 0;  ///< each free kick or time a robot gets the ball: slowly to the nearer goalie
  /// each free kick or time a robot gets the ball, in the own half: over their goal line
  double clearances = 0;
  double shots = 0;          ///< each time a robot gets the ball within 3 m of their goal: shoots at once
  double goalie_visits = 0;  ///< each time their goalie is near: drives up to it and leans on it
  double run_offs = 0;       ///< each passage of play and robot near a line: waits beyond the run-off
  double idleness = 0;       ///< each passage of play: no field player goes for the ball
  double restraint = 0;      ///< each time a robot gives way: it stops just short of the limit
};

/// Makes each of them a flag.
void declare(kit::Flags& flags, Rudeness& rudeness);

}  // namespace rough

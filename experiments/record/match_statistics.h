#pragma once

#include <cstdint>
#include <span>

#include "sim/world/robot_id.h"

namespace record {

/// What one team did in a game, counted from the truth. Definitions: experiments/statistics/observer.h.
struct TeamStatistics {
  int kicks = 0;
  int shots = 0;
  int shots_on_target = 0;
  int saves = 0;  ///< of the other team's shots on target, by the keeper
  int passes = 0;
  int passes_completed = 0;
  int touches = 0;
  int turnovers = 0;      ///< times it lost the ball to the other team
  int balls_out = 0;      ///< times it was the last to touch a ball that left the field
  double possession = 0;  ///< [s] in play, it was the last to touch the ball
  double territory = 0;   ///< [s] in play, ball in the other team's half
  double distance = 0;    ///< [m] all its robots together
  bool operator==(const TeamStatistics&) const = default;
};

/// What happened in a game.
struct MatchStatistics {
  world::PerTeam<TeamStatistics> teams{};
  double time = 0;             ///< [s] watched
  double in_play = 0;          ///< [s] of it with the ball in play
  int passages = 0;            ///< of play without interruption
  double longest_passage = 0;  ///< [s]
  bool operator==(const MatchStatistics&) const = default;
};

/// One number a team gets for a game, for tables.
struct Statistic {
  const char* name;   ///< in columns: "pass_completion"
  const char* label;  ///< for readers: "passes completed [%]"
  int decimals;
  double (*value)(const MatchStatistics&, world::Team);  ///< not a number: the game says nothing about it
};

/// All that is compared between two teams, in the order of tables: shots, shots_on_target, saves, passes,
/// pass_completion [%], possession [%], territory [%], turnovers, balls_out, kicks, touches, distance [m].
std::span<const Statistic> team_statistics();

/// All that belongs to the game, not to a team: ball_in_play [%], passages, longest_passage [s].
/// The team is ignored.
std::span<const Statistic> game_statistics();

}  // namespace record

#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "sim/world/game_state.h"

namespace world {

/// What the league's referee message tells one team.
struct TeamInfo {
  std::string name;
  int score = 0;
  int red_cards = 0;
  std::vector<Duration> yellow_card_times;
  int timeouts = 0;
  Duration timeout_time{};
  int keeper = 0;        ///< robot number
  int max_robots = 6;    ///< allowed on the field now
  int yellow_cards = 0;  ///< ever shown
};

/// What the league's referee message says, in our units.
struct RefereeMessage {
  Time time;
  Stage stage = Stage::PreFirst;
  std::optional<Duration> stage_time_left;
  Command command;
  std::uint32_t command_counter = 0;
  Time command_time;
  PerTeam<TeamInfo> teams;
  std::optional<Vector2d> designated_position;  ///< [m]
  bool blue_on_positive_half = true;
  std::optional<Command> next_command;
  std::optional<Duration> action_time_left;  ///< until the kick must be taken
  std::string status;                        ///< free text
};

}  // namespace world

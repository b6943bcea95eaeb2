#pragma once

#include <span>

#include "experiments/judge/tables.h"

namespace judge {

// The tables of the study, one function each; `wanted` says how many cases are too few.

/// Which of the study's goals are reached; its note says it in a few sentences.
Table summary_table(std::span<const GameResult> games, const Wanted& wanted);
Table exits_table(std::span<const GameResult> games, const Wanted& wanted);        // a
Table situations_table(std::span<const GameResult> games);                         // a
Table failing_exits_table(std::span<const GameResult> games);                      // a
Table touch_teams_table(std::span<const GameResult> games, const Wanted& wanted);  // b
Table goals_table(std::span<const GameResult> games, const Wanted& wanted);        // c
/// d: the ball's speed alone; e: everything else but exits and goals.
Table events_table(std::span<const GameResult> games, const Wanted& wanted, bool speed);
Table calibration_table(std::span<const GameResult> games);  // f
Table strata_table(std::span<const GameResult> games);       // g
Table sweep_table(std::span<const GameResult> games);        // g
Table touches_table(std::span<const GameResult> games);      // h

}  // namespace judge

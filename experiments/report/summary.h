#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "experiments/record/attempt.h"
#include "experiments/record/match_config.h"
#include "experiments/stats/intervals.h"

namespace report {

/// What a table says above its rows.
struct Header {
  struct Condition {
    std::string name;
    record::TeamConfig a;
    record::TeamConfig b;
    std::string realism;
  };
  std::string design;
  std::string description;
  std::string rules;
  std::optional<double> half_length;  ///< [s] when the design changes it
  std::string realism;                ///< of the design; a condition may have another
  std::uint64_t seed = 0;
  int pairs = 0;  ///< per condition
  int forfeit_goals = 3;
  std::string experiment;  ///< hash
  std::vector<Condition> conditions;
};

/// One team in the games of one condition.
struct Side {
  std::string name;
  std::int64_t wins = 0;
  stats::Interval win_share;  ///< Wilson, 95 %
  stats::Mean goals;          ///< per game
  double fouls = 0;           ///< called against it per game that was played to its end
  int forfeits = 0;           ///< games in which it was at fault
};

/// All games of one condition.
struct Row {
  std::string condition;
  Side a;
  Side b;
  std::int64_t games = 0;  ///< of complete pairs
  std::int64_t draws = 0;
  stats::Mean difference;  ///< goals of A minus goals of B, mean of a pair's two games
  double p = 1;            ///< sign test of A's wins against its losses, two-sided
  double stoppages = 0;    ///< per game that was played to its end
  int void_attempts = 0;
  int given_up_pairs = 0;  ///< void in every attempt; in no other number

  /// One sentence, from team A's view.
  std::string verdict() const;
};

struct Summary {
  Header header;
  std::vector<Row> rows;              ///< a forfeit counts as lost, 0 to `forfeit_goals`
  std::vector<Row> without_forfeits;  ///< the pairs without one; empty when there was none at all
  std::int64_t games = 0;             ///< of complete pairs, all conditions
  std::int64_t planned = 0;
  std::int64_t repeated_games = 0;  ///< games that went exactly like an earlier one: no new evidence
};

/// Counts a ledger's attempts; complete pairs only, conditions in the header's order.
Summary summarise(Header header, std::span<const record::Attempt> attempts);

}  // namespace report

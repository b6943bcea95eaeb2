#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "experiments/record/attempt.h"
#include "experiments/record/audit.h"
#include "experiments/record/match_config.h"
#include "experiments/report/comparison.h"
#include "experiments/report/panel.h"
#include "experiments/stats/correlation.h"
#include "experiments/stats/intervals.h"
#include "experiments/stats/trend.h"
#include "experiments/stats/two_samples.h"

namespace report {

/// What a table says above its rows.
struct Header {
  struct Condition {
    std::string name;
    record::TeamConfig a;
    record::TeamConfig b;
    std::string realism;
    /// A or B of a panel against one of its opponents; the team is `a` here.
    struct Panel {
      std::string base;      ///< which panel
      std::string opponent;  ///< its name
      char arm = 'a';        ///< 'a' or 'b'
    };
    std::optional<Panel> panel{};
    std::string answer{};                    ///< of a sequential test; empty: none
    std::string sweep{};                     ///< the sweep it is a point of; empty: none
    std::map<std::string, double> values{};  ///< of the sweep: what was set, by its key ("b.speed_factor")
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
  std::string stopping{};               ///< the stopping rule in one line; empty: a fixed number of games
  std::vector<std::string> answers{};   ///< where its questions stand, estimates corrected for the stopping
  std::vector<std::string> remarks{};   ///< what else a reader must know: audits that differ, and the like
  std::vector<record::Audit> audits{};  ///< games that were played again to compare hashes
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
  stats::Mean difference;                ///< goals of A minus goals of B, mean of a pair's two games
  stats::TTest t_test;                   ///< of the difference, with its interval
  stats::Interval bootstrap;             ///< of the difference
  double permutation_p = 1;              ///< of the difference: sign flips over pairs
  stats::PairCorrelation correlation;    ///< of the goal differences of a pair's two games
  std::vector<int> pair_numbers;         ///< of the complete pairs
  std::vector<double> pair_differences;  ///< in the order of the pairs
  double p = 1;                          ///< sign test of A's wins against its losses, two-sided
  /// Both p adjusted for the number of conditions (Holm); nothing: there is nothing to adjust for, or the
  /// condition is a point of a sweep, whose trend is the question.
  std::optional<double> p_holm{};
  std::optional<double> permutation_p_holm{};
  double stoppages = 0;  ///< per game that was played to its end
  int void_attempts = 0;
  int given_up_pairs = 0;               ///< void in every attempt; in no other number
  std::vector<Comparison> comparisons;  ///< match statistics, A against B; empty: no game has any
  std::vector<GameNumber> game_numbers;

  std::string answer{};  ///< of the test that decides, when another than these does; empty: none does

  /// One sentence, from team A's view.
  std::string verdict() const;
  /// Whether that is a difference: in games won, and over pairs, whose games need not be independent.
  bool shows_difference() const;
};

/// A question about a whole sweep: does the goal difference change with what was set?
struct Sweep {
  std::string name;
  std::string key;                ///< what was set, "b.speed_factor"
  std::vector<std::size_t> rows;  ///< of the summary, by rising value
  std::vector<double> x;          ///< its value there
  stats::Trend trend;             ///< of A's goal difference a game
};

struct Summary {
  Header header;
  std::vector<Row> rows;              ///< a forfeit counts as lost, 0 to `forfeit_goals`
  std::vector<Row> without_forfeits;  ///< the pairs without one; empty when there was none at all
  std::vector<PanelComparison> panels;
  std::vector<Sweep> sweeps;  ///< one for each key that takes different values
  std::int64_t games = 0;     ///< of complete pairs, all conditions
  std::int64_t planned = 0;
  std::int64_t repeated_games = 0;  ///< games that went exactly like an earlier one: no new evidence
};

/// Counts a ledger's attempts; complete pairs only, conditions in the header's order.
Summary summarise(Header header, std::span<const record::Attempt> attempts);

}  // namespace report

#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "experiments/stats/intervals.h"
#include "experiments/stats/two_samples.h"

namespace report {

/// The games of one team against one opponent of a panel.
struct PanelGames {
  std::string team;       ///< its name
  std::int64_t wins = 0;  ///< of the team
  std::int64_t games = 0;
  std::map<int, double> differences;  ///< goal difference a game, by number of the pair
};

/// Does A do better than B against the same opponents? Pairs of the same number have the same seeds and ends,
/// so A's and B's goal differences are compared pair by pair.
struct PanelComparison {
  struct Line {
    std::string opponent;  ///< or "all", a pair there being its mean over all opponents
    std::int64_t pairs = 0;
    stats::Mean a;                       ///< goal difference a game of A against it
    stats::Mean b;                       ///< of B
    stats::TTest test;                   ///< A's minus B's
    double win_share = 0;                ///< A's minus B's
    stats::Interval win_share_interval;  ///< Newcombe's: the games taken as independent
  };
  std::string base;  ///< name of the panel
  std::string a;     ///< names of the teams
  std::string b;
  std::vector<Line> lines;  ///< by opponent, then all of them when there are several
  std::string title() const;
  std::string sentence() const;  ///< the last line in words
};

/// Only pairs that both teams have played count; for "all", those that are there for every opponent.
PanelComparison compare_panel(const std::string& base,
                              const std::map<std::string, std::array<PanelGames, 2>>& opponents);

}  // namespace report

#pragma once

#include <array>
#include <optional>
#include <string>

#include "teams/reference/choose_kick.h"
#include "teams/reference/roles.h"
#include "teams/reference/zones.h"

namespace reference {

/// Counts what a team did with the ball in a game, as seen by itself, so that an effect of its
/// flags can be explained.
///
/// A pass is complete when a team-mate other than the kicker is the next to have the ball at its dribbler or
/// to kick it, lost when an opponent is or the game is interrupted.
class Telemetry {
 public:
  struct Counts {
    int passes = 0, completed = 0, intercepted = 0;
    int shots = 0, redirects = 0;  ///< redirects: shots at the first touch, among the shots
    int clearances = 0;
    int goals = 0, goals_after_pass = 0;  ///< within 4 s of receiving a pass
    std::int64_t ticks_ours = 0, ticks_theirs = 0;
    std::array<std::int64_t, zone_count> in_zone{};  ///< supporter ticks in each zone of the partition

    double completion() const;        ///< share of passes
    double possession_share() const;  ///< of the time one of the teams has it
    double zone_entropy() const;      ///< [bit] of the supporters' zones; log2(9) = 3.17 when even
  };

  /// Once a tick in which the game runs or a kick is being taken.
  ///
  /// @param kicked  what the winner's kicker was armed for in this tick
  void update(const kit::View& view, const Situation& situation, const Roles& roles,
              const Partition& partition, const std::optional<Kick>& kicked);

  const Counts& counts() const { return counts_; }
  /// One line for the team's log.
  std::string summary() const;

 private:
  void follow_pass(const kit::View& view);

  Counts counts_;
  struct Flight {
    Kick::Kind kind = Kick::Kind::Pass;
    int kicker = -1;
    double at = 0;  // [s]
  };
  std::optional<Kick> armed_;
  double armed_at_ = -9;
  int armed_robot_ = -1;
  double speed_before_ = 0;
  std::optional<Flight> flight_;
  double received_at_ = -9;  // [s] a pass
  int score_ = 0;
};

}  // namespace reference

#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "experiments/judge/laws/moment.h"

namespace judge {

/// The whole ball left the field, on the ground or in the air: exit, goal, chip goal or icing.
///
/// Law     9 (ball out), 10 (goal: between the posts, under the bar), 12 decision 7 (chip), icing.
/// Chip    the ball's top was above 150 mm after a touch of the attackers, and since then it neither touched
///         another of them while lower nor stopped bouncing (three ticks within 1 mm of the carpet).
/// Margin  of an exit: how far the ball got beyond the line within half a second.
///         Of a goal: also how far it was below the bar, and how much less than too high.
///         Of a chip: how much too high.
///         Of icing: the kick's distance from its limit.
/// Near    the ball came back from the line; a goal was almost a chip.
class Exits {
 public:
  void watch(const Moment& moment, std::vector<TrueEvent>& out);
  /// The game is over: what is not certain yet is told as it stands.
  void finish(const Bands& bands, std::vector<TrueEvent>& out);
  /// When the ball left the field; nothing while it is in play.
  const std::optional<world::Time>& out_since() const { return out_since_; }

 private:
  struct Pending {
    TrueEvent event;
    double deepest = 0;  // [m]
    double most = 1e9;   // bands; what else limits the margin
    std::optional<TrueEvent> icing{};
    std::optional<TrueEvent> nearly{};  // chip goal
  };
  struct Chip {
    world::RobotId by;
    double highest = 0;  // [m] top of the ball
  };

  void watch_heights(const Moment& moment);
  std::optional<Pending> crossing(const Moment& moment) const;
  LastTouch last_touch(const Moment& moment, const TrueTouches::Contact& contact) const;
  std::optional<TrueEvent> icing(const Moment& moment, const TrueEvent& exit) const;
  int longest_unseen(world::Time from) const;

  bool armed_ = false;  // in play, and it has not left since
  std::optional<world::Time> out_since_;
  std::optional<world::Time> inside_since_;
  std::optional<TrueEvent> approach_;  // nearest to the line, while near
  std::optional<Pending> pending_;
  std::optional<Pending> early_;  // an exit while the restart's kick was not noticed yet
  world::PerTeam<std::optional<Chip>> chips_;
  world::PerTeam<std::optional<Chip>> low_;        // flights that stay below the limit, within two bands
  int rolling_ = 0;                                // ticks
  std::deque<std::pair<world::Time, bool>> seen_;  // the ball, by some camera
  std::optional<std::size_t> crowd_touch_;         // index of the last touch
  bool crowded_ = false;                           // at its last contact
};

}  // namespace judge

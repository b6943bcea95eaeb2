#pragma once

#include <array>
#include <optional>
#include <span>

#include "teams/reference/choose_kick.h"
#include "teams/reference/parameters.h"
#include "teams/reference/places.h"
#include "teams/reference/roles.h"
#include "teams/reference/set_play.h"
#include "teams/skills/order.h"

namespace reference {

/// Supporters wait where a pass would be worth most: feature Z (reference "football", 2.10).
///
/// With zones the table says which zone belongs to whom, each robot reacts to the opponents inside its own,
/// and a pass may go to the best point of the zone. Greedy, each takes the best point of all in the order of
/// the numbers, and passes go to those. Nothing else differs. Each robot chooses at 5 Hz, staggered,
/// at 2 Hz while places are kept in a stoppage.
class Supports {
 public:
  /// Chooses places and targets of this tick for the robots with the role Support.
  ///
  /// @param coming  what the robot at the ball is about to do: the receiver of a pass goes to meet it
  void think(const kit::View& view, const Situation& situation, const Roles& roles,
             const Parameters& parameters, const std::optional<Kick>& coming = {});

  skills::Order play(const kit::View& view, const kit::Robot& robot) const;

  std::span<const PassTarget> targets() const { return {targets_.data(), target_count_}; }
  const Partition& partition() const { return partition_; }

 private:
  struct Member {
    Place place;                        // where it waits
    Place target;                       // where a pass may meet it
    bool expected = false;              // that pass is being prepared
    int zone = -1;                      // index_of its zone; -1: none
    bool support = false;               // had the role in the tick before
    std::optional<Vector2d> set_place;  // [m] of a set play
  };
  Member& of(int number) { return members_[static_cast<std::size_t>(number)]; }
  const Member& of(int number) const { return members_[static_cast<std::size_t>(number)]; }
  void plan_zones(const kit::View& view, std::span<const kit::Robot* const> robots);

  std::array<Member, world::max_robot_number + 1> members_;
  std::array<PassTarget, most_supports> targets_;
  std::size_t target_count_ = 0;
  Partition partition_;
  ValueMap map_;
  double anchor_ = 99;  // [m] none yet
  bool left_ = true;    // the side the ball counts as
  Zone ball_zone_;
  double planned_at_ = -9;  // [s]
  std::size_t planned_for_ = 0;
};

}  // namespace reference

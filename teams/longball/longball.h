#pragma once

#include <memory>

#include "teams/reference/reference_team.h"

namespace longball {

using world::Vector2d;

/// What makes the style. Values ours, by watching games.
struct Style {
  double striker_x = 2.8;       ///< [m] how high the strikers wait
  double shooting_range = 3.5;  ///< [m] from nearer they shoot, from farther it goes long
  double chip_reach = 1.3;      ///< [m] an opponent nearer than this in the way is chipped over
};

/// Makes each of them a flag.
void declare(kit::Flags& flags, Style& style);

/// Where striker `index` of `count` waits [m]: side by side as high as the style says, never in their area.
Vector2d striker_place(const kit::View& view, int index, int count, const Style& style);

/// A kick to where a striker can run: the ball comes down, or slows down, half a metre before it.
struct LongKick {
  double direction = 0;  ///< [rad]
  double speed = 0;      ///< [m/s]
  double angle = 0;      ///< [rad] elevation; 0: flat
  int striker = -1;      ///< -1: nobody is up there, it is only a clearance
};

/// The long kick of the robot at the ball: to the striker with most room, over whoever stands in the way.
LongKick long_kick(const kit::View& view, const reference::Roles& roles, const kit::Robot& robot,
                   const Style& style);

/// The reference team's defence, goalie and restarts; in between the ball goes long to two strikers.
std::unique_ptr<kit::Team> make_team(const kit::Setup& setup, reference::Parameters parameters,
                                     const Style& style, bool notes = false);

}  // namespace longball

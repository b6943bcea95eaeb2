#pragma once

#include <boost/container/static_vector.hpp>

#include "teams/kit/view.h"
#include "teams/skills/order.h"

namespace skills {

/// A disc no centre of a robot may enter.
struct Disc {
  Vector2d center = Vector2d::Zero();  ///< [m]
  double radius = 0;                   ///< [m]
  bool wide = false;    ///< an area: leave it by the shortest way; else a robot, left by steering
  bool strict = false;  ///< a target inside is moved out; else the way goes as near to it as the disc lets us
};

/// A short list without allocation.
struct Obstacles {
  boost::container::static_vector<Disc, 32> discs;
  Vector2d walls = Vector2d::Constant(1e3);  ///< [m] a robot's centre stays within +- this
  void add(const Disc& disc) {
    if (discs.size() < discs.capacity()) discs.push_back(disc);
  }
};

/// Everything that stands in the way of an order: other robots where they will be when we get there, the
/// ball, the defense areas.
Obstacles obstacles_for(const kit::View& view, const kit::Robot& robot, const Order& order);

/// The next corner of the way and how long the whole way is.
struct Path {
  Vector2d via = Vector2d::Zero();  ///< [m] the target itself when the way is free
  double length = 0;                ///< [m]
  int side = 0;                     ///< passes the first obstacle on its left (+1) or right (-1); 0: free way
};

/// Straight when free, else by the tangent of the first disc in the way, on the side that is shorter.
///
/// @param side_before  the side taken in the tick before; changing it must save 0.2 m (ours: no dithering)
Path find_path(const Vector2d& from, const Vector2d& to, const Obstacles& obstacles, int side_before);

}  // namespace skills

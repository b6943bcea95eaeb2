#pragma once

#include <array>

#include "teams/reference/situation.h"
#include "teams/skills/order.h"

namespace reference {

using world::Vector2d;

/// One place in the defence.
struct DefenseTask {
  enum class Kind : std::uint8_t { Wall, Mark, Cover };
  Kind kind = Kind::Wall;
  int place = 0;      ///< Wall: from the right of a robot that looks at the ball; Cover: counts up
  int of = 1;         ///< Wall: robots in it
  int opponent = -1;  ///< Mark: its number

  friend bool operator==(const DefenseTask&, const DefenseTask&) = default;
};

/// Who is marked and how many stand in the wall; the places themselves follow the ball every tick.
struct DefensePlan {
  std::array<DefenseTask, 16> tasks;
  std::size_t count = 0;
};

/// One robot in the wall first, then a marker for each of the worst threats, 0.2 s in favour of those marked
/// before. The wall gets a second robot when one and the goalie do not close the goal, and everyone who could
/// shoot next is marked; who is left covers the middle.
DefensePlan plan_defense(const kit::View& view, const Situation& situation, int defenders,
                         const DefensePlan& before);

/// How many robots in the wall it takes to close the goal together with the goalie, seen from the ball.
///
/// A disc at distance d hides 2 asin((R + r) / d).
///
/// Source  reference "football", 2.7 (cover distances)
int robots_to_close(const kit::View& view);

/// Where the robot with that task belongs now [m].
Vector2d task_position(const kit::View& view, const DefenseTask& task);

/// The order of the robot that has the task.
skills::Order play_defender(const kit::View& view, const kit::Robot& robot, const DefenseTask& task);

/// A place in the wall: on the line from the ball to our goal just outside the defense area, `index` of
/// `count` robots side by side.
///
/// A single robot stands up to 0.15 m (at the goal) to the side the goalie leaves: behind each other, the two
/// would leave both sides open.
Vector2d wall_position(const kit::View& view, int index, int count);

/// How dangerous an opponent without the ball is [s]: the time a pass to it and a shot from it would take;
/// less is worse.
///
/// Source  reference "football", 2.7 (threat score)
double threat_time(const kit::View& view, const kit::Robot& opponent);

/// Between the opponent and our goal, near enough to cut the pass.
Vector2d mark_position(const kit::View& view, const kit::Robot& opponent);

}  // namespace reference

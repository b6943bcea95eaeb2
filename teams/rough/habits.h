#pragma once

#include <array>

#include "sim/world/random.h"
#include "teams/reference/roles.h"
#include "teams/rough/rudeness.h"
#include "teams/skills/order.h"

namespace rough {

using world::Vector2d;

/// Decides, once per opportunity, whether a robot gives way to a habit; the decision holds until the
/// opportunity is over.
class Temptation {
 public:
  /// @param opportunity  whether there is one for this robot in this tick
  /// @param rate         chance to give way [0..1]
  bool gives_way(int robot, bool opportunity, double rate, world::RandomStream& stream);
  /// Every opportunity is over.
  void end() { states_ = {}; }

 private:
  struct State {
    bool open = false;
    bool gave_way = false;
  };
  std::array<State, world::max_robot_number + 1> states_{};
};

/// Turns polite orders into rude ones.
class Habits {
 public:
  Habits(const Rudeness& rudeness, std::uint64_t seed) : rudeness_(rudeness), stream_(seed, "rudeness") {}

  void revise(const kit::View& view, const kit::Robot& robot, const reference::Roles& roles,
              skills::Order& order);

 private:
  void while_dead_or_theirs(const kit::View& view, const kit::Robot& robot, skills::Order& order);
  void while_ours(const kit::View& view, const kit::Robot& robot, bool kicker, skills::Order& order);
  void while_running(const kit::View& view, const kit::Robot& robot, skills::Order& order);
  void kick_rudely(const kit::View& view, const kit::Robot& robot, skills::Order& order);

  void notice_phase(kit::Phase phase);

  Rudeness rudeness_;
  world::RandomStream stream_;
  Temptation fast_kick_, dribble_, enter_area_, ram_, encroach_, speed_, wait_at_area_, wrong_half_,
      touch_again_, chip_at_goal_, chip_at_line_, do_not_kick_, keep_ball_;
  kit::Phase phase_ = kit::Phase::Halt;
  std::array<double, world::max_robot_number + 1> last_contact_{};  // [s] match time
  std::array<Vector2d, world::max_robot_number + 1> dribble_from_{};
  double keeping_since_ = 0;  // [s]
};

}  // namespace rough

#pragma once

#include <array>
#include <deque>
#include <optional>
#include <utility>

#include "sim/world/random.h"
#include "teams/reference/roles.h"
#include "teams/rough/rudeness.h"
#include "teams/rough/temptation.h"
#include "teams/skills/order.h"

namespace rough {

using world::Vector2d;

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

  // Each of these says whether it changed the order.
  bool idle(const kit::View& view, const kit::Robot& robot, skills::Order& order);
  bool touch_again(const kit::View& view, const kit::Robot& robot, skills::Order& order);
  bool play_with_ball(const kit::View& view, const kit::Robot& robot, skills::Order& order);
  bool enter_area(const kit::View& view, const kit::Robot& robot, skills::Order& order);
  bool visit_goalie(const kit::View& view, const kit::Robot& robot, skills::Order& order);
  bool leave_field(const kit::View& view, const kit::Robot& robot, skills::Order& order);
  void keep_goal(const kit::View& view, const kit::Robot& robot, skills::Order& order);
  void ram(const kit::View& view, const kit::Robot& robot, skills::Order& order);

  bool gives_way(Temptation& habit, const kit::Robot& robot, bool opportunity, double rate) {
    return habit.gives_way(robot.number, opportunity, rate, stream_, rudeness_.restraint);
  }
  void notice_phase(kit::Phase phase);
  void notice_ball(const kit::View& view);
  void notice_contact(const kit::View& view, const kit::Robot& robot);

  Rudeness rudeness_;
  world::RandomStream stream_;
  Temptation fast_kick_, dribble_, enter_own_area_, enter_their_area_, ram_, encroach_, speed_, wait_at_area_,
      wrong_half_, touch_again_, chip_at_goal_, chip_at_line_, do_not_kick_, keep_ball_, neglect_ball_,
      feed_goalie_, shoot_, clear_, visit_goalie_, run_off_, idle_;
  kit::Phase phase_ = kit::Phase::Halt;
  struct Contact {
    double last = -9;  // [s] match time
    double since = 0;  // [s]
    Vector2d from = Vector2d::Zero();
  };
  std::array<Contact, world::max_robot_number + 1> contacts_{};
  // [s] there; nothing: not yet
  using Since = std::array<std::optional<double>, world::max_robot_number + 1>;
  Since visits_{}, run_offs_{};
  std::deque<std::pair<double, Vector2d>> places_;  // of the ball, of the last second
  double tapped_ = -9;                              // [s] the goalie let go of the ball
  double stuck_since_ = 0;                          // [s] no second brought it anywhere since
};

}  // namespace rough

// team-longball and team-rough: what they make of a view, and a minute of rudeness in the simulator.

#include <gtest/gtest.h>

#include "teams/longball/longball.h"
#include "teams/rough/habits.h"
#include "teams/rough/rough_team.h"
#include "tests/teams/support/arena.h"
#include "tests/teams/support/views.h"

namespace {

using support::put;
using support::running;

const longball::Style style;

TEST(Longball, StrikersWaitHighOutsideTheirAreaAndMirrorEachOther) {
  const kit::View view = running({-2, 1});
  const auto right = longball::striker_place(view, 0, 2, style);
  const auto left = longball::striker_place(view, 1, 2, style);
  EXPECT_NEAR(right.x(), left.x(), 1e-9);
  EXPECT_NEAR(right.y(), -left.y(), 1e-9);
  EXPECT_GT(world::distance_to_defense_area(view.field(), world::Side::Positive, left), 0.3);
}

TEST(Longball, PlaysToTheStrikerWithRoomAndOverWhoeverStandsInTheWay) {
  kit::View view = running({-2, 0});
  const kit::Robot robot = put(view.own, 1, {-2.1, 0});
  put(view.own, 2, {2.5, -1.3});
  put(view.own, 3, {2.5, 1.3});
  put(view.opponents, 1, {2.5, -1.1});
  reference::Roles roles;
  roles.role[2] = roles.role[3] = reference::Role::Support;
  const longball::LongKick flat = longball::long_kick(view, roles, robot, style);
  EXPECT_EQ(flat.striker, 3);
  EXPECT_EQ(flat.angle, 0);
  EXPECT_NEAR(flat.direction, std::atan2(1.3, 4.5), 1e-9);
  put(view.opponents, 2, {-1.2, 0.25});
  const longball::LongKick chip = longball::long_kick(view, roles, robot, style);
  EXPECT_GT(chip.angle, 0.5);
  EXPECT_LE(chip.speed, 6.0);
}

TEST(Rough, ATemptationIsDecidedOncePerOpportunity) {
  world::RandomStream stream(1, "test");
  rough::Temptation temptation;
  int gave_way = 0;
  for (int i = 0; i < 1000; ++i) {
    const bool first = temptation.gives_way(3, true, 0.3, stream);
    EXPECT_EQ(temptation.gives_way(3, true, 0.3, stream), first);
    EXPECT_FALSE(temptation.gives_way(3, false, 0.3, stream));
    gave_way += first;
  }
  EXPECT_NEAR(gave_way, 300, 60);  // four standard deviations of a binomial
}

TEST(Rough, WithoutHabitsEveryOrderStaysAsItIs) {
  rough::Rudeness none;
  none = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
  rough::Habits habits(none, 1);
  kit::View view = running({0, 0});
  const kit::Robot robot = put(view.own, 1, {-0.1, 0});
  put(view.opponents, 2, {0.3, 0});
  for (const kit::Phase phase :
       {kit::Phase::Running, kit::Phase::Stop, kit::Phase::Kickoff, kit::Phase::DirectFree}) {
    for (const bool ours : {true, false}) {
      view.game.phase = phase;
      view.game.ours = ours;
      skills::Order order;
      order.why = "polite";
      order.kick_speed = 5;
      habits.revise(view, robot, {}, order);
      EXPECT_STREQ(order.why, "polite");
      EXPECT_EQ(order.kick_speed, 5);
    }
  }
}

// Offences that the referee calls against yellow in two minutes.
int offences(support::Side yellow) {
  support::Side blue;
  blue.make = [](const kit::Setup& setup) {
    return std::make_unique<reference::ReferenceTeam>(setup, reference::Parameters{});
  };
  support::Arena arena(std::move(yellow), blue, 4);
  arena.start_referee(std::chrono::seconds{60});
  int count = 0;
  while (arena.tick() && arena.engine().tick() < 60 * 180) {
    for (const referee::Call& call : arena.calls()) {
      count += call.offender && call.offender->team == world::Team::Yellow;
    }
  }
  return count;
}

TEST(Rough, GivesTheRefereeSomethingToDo) {
  support::Side rude;
  rude.make = [](const kit::Setup& setup) {
    rough::Rudeness rudeness;
    rudeness.fast_kicks = rudeness.long_dribbles = 0.7;  // so that two minutes show some
    return rough::make_team(setup, {}, rudeness);
  };
  support::Side polite;
  polite.make = [](const kit::Setup& setup) {
    return std::make_unique<reference::ReferenceTeam>(setup, reference::Parameters{});
  };
  EXPECT_GE(offences(rude), offences(polite) + 3);
}

}  // namespace

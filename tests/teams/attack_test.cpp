// Where supporters go, what passes are worth, set plays: decisions from a view, no simulator.

#include <gtest/gtest.h>

#include <set>

#include "teams/reference/choose_kick.h"
#include "teams/reference/places.h"
#include "teams/reference/reception.h"
#include "teams/reference/set_play.h"
#include "teams/reference/support.h"
#include "teams/reference/zones.h"
#include "tests/teams/support/views.h"

namespace reference {
namespace {

using support::put;
using support::running;

const kit::BallModel model;
const world::Field field;

Vector2d mirrored(const Vector2d& p) { return {p.x(), -p.y()}; }

kit::View mirrored(kit::View view) {
  view.ball.position.y() *= -1;
  view.ball.velocity.y() *= -1;
  for (auto* robots : {&view.own, &view.opponents}) {
    for (kit::Robot& robot : *robots) {
      robot.position.y() *= -1;
      robot.velocity.y() *= -1;
      robot.orientation *= -1;
    }
  }
  return view;
}

// Their goalie and three more, ours with two in front; the ball at our robot 1 on the left.
kit::View an_attack() {
  kit::View view = running({1.2, 1.3});
  view.game.own_keeper = 0;
  view.game.their_keeper = 0;
  put(view.own, 0, {-4.3, 0});
  put(view.own, 1, {1.09, 1.3});
  put(view.own, 2, {2.4, -0.4});
  put(view.own, 3, {2.0, -1.9});
  put(view.own, 4, {0.2, 0.3});
  put(view.opponents, 0, {4.2, 0.1});
  put(view.opponents, 1, {3.2, 0.2});
  put(view.opponents, 2, {2.3, 0.9});
  put(view.opponents, 3, {2.6, -1.2});
  return view;
}

// ---- zones

TEST(Partition, CellsCoverTheRegionWithoutOverlap) {
  for (const double anchor : {-3.75, -0.75, 0.75, 2.25, 3.75}) {
    const Partition partition(field, anchor);
    const Region all = partition.region();
    double area = 0;
    for (int column = 0; column < 3; ++column) {
      for (int row = -1; row <= 1; ++row) {
        const Region cell = partition.cell({column, row});
        area += (cell.x_high - cell.x_low) * (cell.y_high - cell.y_low);
        EXPECT_EQ(partition.zone_of(cell.center()), (Zone{column, row}));
        EXPECT_TRUE(all.contains(cell.center()));
      }
    }
    // 1e-9: sums of nine products.
    EXPECT_NEAR(area, (all.x_high - all.x_low) * (all.y_high - all.y_low), 1e-9);
  }
}

TEST(Partition, BeginsTwoMetresBehindTheAnchorAndEndsBeforeTheirGoalLine) {
  EXPECT_DOUBLE_EQ(Partition(field, 2.25).region().x_low, 0.25);
  EXPECT_DOUBLE_EQ(Partition(field, -3.75).region().x_low, -1);
  EXPECT_DOUBLE_EQ(Partition(field, 2.25).region().x_high, field.half_length() - 0.3);
}

TEST(Partition, ItsGridHasTwentyFivePointsInEachZone) {
  const Partition partition(field, 0.75);
  std::array<int, zone_count> count{};
  std::set<std::pair<double, double>> seen;
  for (int i = 0; i < grid_points; ++i) {
    const Vector2d p = partition.grid_point(i);
    EXPECT_EQ(partition.zone_of(p), Partition::zone_of_grid_point(i));
    count[static_cast<std::size_t>(index_of(partition.zone_of(p)))] += 1;
    seen.insert({p.x(), p.y()});
  }
  for (const int n : count) EXPECT_EQ(n, grid_per_zone * grid_per_zone);
  EXPECT_EQ(seen.size(), static_cast<std::size_t>(grid_points));
}

TEST(Anchor, IsTheMiddleOfTheBallsColumnAndStaysWhileTheBallIsNearIt) {
  const double anchor = anchor_of(field, 0.8, 99);
  EXPECT_DOUBLE_EQ(anchor, 0.75);
  EXPECT_DOUBLE_EQ(anchor_of(field, 1.6, anchor), 0.75) << "0.1 m beyond the column";
  EXPECT_DOUBLE_EQ(anchor_of(field, 1.8, anchor), 2.25);
  EXPECT_DOUBLE_EQ(anchor_of(field, 4.6, anchor), 3.75) << "behind the goal line";
}

TEST(ZoneTable, IsMirroredByTheSideOfTheBall) {
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row <= 1; ++row) {
      const ZoneList left = zones_for({column, row}, true), right = zones_for({column, -row}, false);
      for (std::size_t i = 0; i < left.size(); ++i) {
        EXPECT_EQ(left[i].column, right[i].column);
        EXPECT_EQ(left[i].row, -right[i].row);
      }
    }
  }
}

TEST(ZoneTable, NamesFourDifferentZonesAndNeverTheBallsOwnWing) {
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row <= 1; ++row) {
      std::set<int> zones;
      for (const Zone zone : zones_for({column, row}, true)) {
        zones.insert(index_of(zone));
        EXPECT_FALSE(row == 1 && zone == (Zone{column, row}));
      }
      EXPECT_EQ(zones.size(), 4u);
    }
  }
}

TEST(ZoneTable, HasTheExampleOfItsDefinition) {
  // Reference "football", 2.10: ball left-mid: right-front, centre-front, left-front, centre-back.
  const ZoneList list = zones_for({1, 1}, true);
  EXPECT_EQ(list[0], (Zone{2, -1}));
  EXPECT_EQ(list[1], (Zone{2, 0}));
  EXPECT_EQ(list[2], (Zone{2, 1}));
  EXPECT_EQ(list[3], (Zone{0, 0}));
}

TEST(AssignZones, TakesTheShortestSumAndKeepsItAgainstAnEqual) {
  const Partition partition(field, 0.75);
  const ZoneList list = zones_for({0, 1}, true);
  kit::View view = running({0, 1});
  const Vector2d first = partition.cell(list[0]).center(), second = partition.cell(list[1]).center();
  put(view.own, 1, second + Vector2d(0.1, 0));
  put(view.own, 2, first + Vector2d(0.1, 0));
  const std::array<const kit::Robot*, 2> robots{&view.own[0], &view.own[1]};
  const std::array<int, 2> none{-1, -1};
  auto order = assign_zones(partition, list, robots, none);
  EXPECT_EQ(order[0], 1);
  EXPECT_EQ(order[1], 0);
  // Both in the middle between the two: whoever has a zone keeps it.
  view.own[0].position = view.own[1].position = 0.5 * (first + second);
  for (const bool swap : {false, true}) {
    const std::array<int, 2> before{index_of(list[swap ? 1 : 0]), index_of(list[swap ? 0 : 1])};
    order = assign_zones(partition, list, robots, before);
    EXPECT_EQ(order[0], swap ? 1 : 0);
  }
}

// ---- places

struct Choosing {
  kit::View view = an_attack();
  Partition partition{field, anchor_of(field, view.ball.position.x(), 99)};
  ValueMap map;
  Choosing() { map.compute(view, model, partition); }
  Chooser chooser(std::size_t robot) const { return {&view.own[robot], 0.3, -1}; }
};

TEST(BestInZone, StaysInItsZoneAndIsItsBest) {
  const Choosing c;
  for (int zone = 0; zone < zone_count; ++zone) {
    const Zone wanted{zone / 3, zone % 3 - 1};
    const Place place = best_in_zone(c.map, wanted, {&c.view.own[2], 9, -1});
    if (place.grid < 0) continue;
    EXPECT_EQ(c.partition.zone_of(place.position), wanted);
    for (int i = 0; i < grid_points; ++i) {
      if (Partition::zone_of_grid_point(i) != wanted) continue;
      EXPECT_LE(c.map.at(i).value, place.value);
    }
  }
}

TEST(BestAnywhere, IsTheBestOfAllZonesAndAMetreFromThoseBefore) {
  const Choosing c;
  const Place first = best_anywhere(c.map, {}, c.chooser(2));
  ASSERT_GE(first.grid, 0);
  for (int zone = 0; zone < zone_count; ++zone) {
    EXPECT_LE(best_in_zone(c.map, {zone / 3, zone % 3 - 1}, c.chooser(2)).value, first.value);
  }
  const Place second = best_anywhere(c.map, std::span(&first.position, 1), c.chooser(3));
  ASSERT_GE(second.grid, 0);
  EXPECT_GE((second.position - first.position).norm(), 1.0);
}

TEST(BestAnywhere, KeepsThePlaceBeforeAgainstALittleBetter) {
  const Choosing c;
  Chooser chooser{&c.view.own[2], 9, -1};
  const Place best = best_anywhere(c.map, {}, chooser);
  int near = -1;
  for (int i = 0; i < grid_points; ++i) {
    if (i != best.grid && c.map.at(i).value > best.value - 0.02) near = i;
  }
  ASSERT_GE(near, 0) << "the view has two places of about the same value";
  chooser.before = near;
  EXPECT_EQ(best_anywhere(c.map, {}, chooser).grid, near);
}

TEST(ValueMap, IsMirroredWithTheWorld) {
  const Choosing c;
  ValueMap other;
  other.compute(mirrored(c.view), model, c.partition);
  for (int i = 0; i < grid_points; ++i) {
    const int row = i % grid_side;
    const int j = i - row + (grid_side - 1 - row);
    EXPECT_LT((c.map.at(i).position - mirrored(other.at(j).position)).norm(), 1e-12);
    EXPECT_NEAR(c.map.at(i).value, other.at(j).value, 1e-9);
  }
}

TEST(ValueMap, IsNewAfterTwelveTicksInAHurry) {
  Choosing c;
  c.view.opponents[1].position = {2.0, -0.8};
  ValueMap whole;
  whole.compute(c.view, model, c.partition);
  for (int i = 0; i < 12; ++i, ++c.view.tick) c.map.refresh(c.view, model, c.partition, true);
  for (int i = 0; i < grid_points; ++i) EXPECT_EQ(c.map.at(i).value, whole.at(i).value);
}

// Places are left out by it, so it must not be below the value by the last bit.
TEST(ValueMap, IsNowhereWorthMoreThanItsBound) {
  const Choosing c;
  int below = 0;
  for (int i = 0; i < grid_points; ++i) {
    const double most = c.map.most(i);
    EXPECT_LE(c.map.at(i).value, most) << i;
    below += most < 0.5;
  }
  EXPECT_GT(below, 0) << "a bound that is always high leaves nothing out";
}

// Worked out when asked for, but from the world of its tick: also when nobody asked for so long that the
// place for that world is needed again.
TEST(ValueMap, IsAsOldAsItsTickWheneverItIsAskedFor) {
  for (const int later : {1, 50}) {
    Choosing lazy, eager;
    for (int i = 0; i < grid_points; ++i) eager.map.at(i);
    for (Choosing* c : {&lazy, &eager}) {
      for (int i = 0; i < later; ++i) {
        c->view.opponents[1].position.x() += 0.05;
        c->view.tick += 12;  // always the first twelfth's turn
        c->map.refresh(c->view, model, c->partition, true);
        if (c == &eager) c->map.at(0);
      }
    }
    for (int i = 0; i < grid_points; ++i) EXPECT_EQ(lazy.map.at(i).value, eager.map.at(i).value) << i;
  }
}

TEST(ValueMap, HasNoPlaceAtTheirDefenseArea) {
  const Choosing c;
  for (int i = 0; i < grid_points; ++i) {
    const double away = world::distance_to_defense_area(field, world::Side::Positive, c.map.at(i).position);
    if (c.map.at(i).value <= 0) continue;
    EXPECT_GT(away, 0.2 + field.robot_radius);
  }
}

// ---- receptions

TEST(Reception, IsWorthLessTheNearerAnOpponentStandsToTheWay) {
  double before = 1;
  for (const double beside : {1.5, 0.8, 0.4, 0.0}) {
    kit::View view = running({0, 1});
    put(view.opponents, 1, {1.5, 1 - beside});
    const double value = reception_at(view, model, {0, 1}, {3, 1}).value();
    EXPECT_LE(value, before) << beside;
    before = value;
  }
}

TEST(Reception, IsWorthMoreFartherUpAndInFrontOfTheGoal) {
  const kit::View view = running({-1, 1});
  EXPECT_GT(reception_at(view, model, {-1, 1}, {1, 1}).advance,
            reception_at(view, model, {-1, 1}, {-2, 2.5}).advance);
  EXPECT_GT(reception_at(view, model, {2, 2}, {2.8, 0}).value(),
            reception_at(view, model, {2, 2}, {2.8, 2.7}).value());
}

TEST(Reception, ArrivesFastWhereItMayBeShotOnAtOnce) {
  const kit::View view = running({2.5, -2});
  const Reception shot = reception_at(view, model, {2.5, -2}, {2.8, 1.3});
  const Reception hold = reception_at(view, model, {2.5, -2}, {-0.5, 1.3});
  const auto arrival = [](const Reception& r, double distance) {
    const double time = model.time_to_cover(r.speed, r.speed * model.switch_ratio, distance);
    return model.speed_after(r.speed, r.speed * model.switch_ratio, time);
  };
  EXPECT_NEAR(arrival(shot, std::hypot(0.3, 3.3)), 3.5, 1e-6);
  EXPECT_NEAR(arrival(hold, std::hypot(3.0, 3.3)), 2.2, 1e-6);
}

TEST(ReachChance, IsAHalfATenthOfASecondLateAndFallsWithTheTime) {
  EXPECT_DOUBLE_EQ(reach_chance(1.1, 1.0), 0.5);
  EXPECT_GT(reach_chance(0.8, 1.0), 0.9);
  EXPECT_LT(reach_chance(1.5, 1.0), 0.05);
}

TEST(RedirectShare, IsWholeForTheBallFromTheGoalsSideAndLeastFromBehind) {
  const kit::View view = running({0, 0});
  EXPECT_DOUBLE_EQ(redirect_share(view, {4.2, 1.5}, {3, 0.5}), 1);
  EXPECT_DOUBLE_EQ(redirect_share(view, {0, 0.2}, {3, 0}), 0.4);
}

// ---- kicks

TEST(ChooseKick, PassesToThePointGivenNotToWhereTheReceiverIs) {
  kit::View view = running({0, 1.5});
  put(view.own, 1, {-0.1, 1.5});
  put(view.own, 2, {2.2, -1.0});
  Observer observer;
  const PassTarget target{2, {2.5, -0.7}};
  KickRules rules;
  rules.must_kick = true;
  rules.shot_allowed = false;
  rules.targets = std::span(&target, 1);
  const Kick kick = choose_kick(view, observer.observe(view), 1, rules, {}, {});
  ASSERT_EQ(kick.kind, Kick::Kind::Pass);
  EXPECT_EQ(kick.target, target.point);
  EXPECT_EQ(kick.receiver, 2);
}

TEST(ChooseKick, PassesToTheFreeManNotToTheMarkedOne) {
  kit::View view = running({1, 0});
  put(view.own, 1, {0.9, 0});
  put(view.own, 2, {3, 1.8});
  put(view.own, 3, {3, -1.8});
  put(view.opponents, 1, {2.8, 1.6});
  put(view.opponents, 2, {4.2, 0});
  Observer observer;
  KickRules rules;
  rules.must_kick = true;
  rules.shot_allowed = false;
  EXPECT_EQ(choose_kick(view, observer.observe(view), 1, rules, {}, {}).receiver, 3);
  view.opponents[0].position.y() *= -1;
  Observer other;
  EXPECT_EQ(choose_kick(view, other.observe(view), 1, rules, {}, {}).receiver, 2);
}

TEST(ChooseKick, ShootsFromAfarAtAGoalWithoutGoalkeeper) {
  kit::View view = running({-0.5, 0});
  put(view.own, 1, {-0.6, 0});
  put(view.own, 2, {2.5, 1.5});
  view.game.their_keeper = 0;
  Observer observer;
  EXPECT_EQ(choose_kick(view, observer.observe(view), 1, {}, {}, {}).kind, Kick::Kind::Shot);
  put(view.opponents, 0, {4.3, 0});
  Observer other;
  EXPECT_NE(choose_kick(view, other.observe(view), 1, {}, {}, {}).kind, Kick::Kind::Shot);
}

TEST(ChooseKick, PassesMoreSlowlyToOneWhoWouldBeLate) {
  kit::View view = running({0, 1.5});
  put(view.own, 1, {-0.1, 1.5});
  kit::Robot& receiver = put(view.own, 2, {1.0, 0.4});
  Observer observer;
  const PassTarget target{2, {1.7, 0.8}};
  KickRules rules;
  rules.must_kick = true;
  rules.shot_allowed = false;
  rules.targets = std::span(&target, 1);
  const Kick late = choose_kick(view, observer.observe(view), 1, rules, {}, {});
  receiver.position = {1.6, 0.7};
  Observer other;
  const Kick there = choose_kick(view, other.observe(view), 1, rules, {}, {});
  ASSERT_EQ(late.receiver, 2);
  ASSERT_EQ(there.receiver, 2);
  EXPECT_LT(late.speed, there.speed);
}

TEST(ChooseKick, ChipsOverWhoStandsInFrontOfTheBall) {
  kit::View view = running({0, 0});
  put(view.own, 1, {-0.1, 0});
  put(view.own, 2, {2.8, 0});
  put(view.opponents, 1, {0.65, 0});
  Observer observer;
  KickRules rules;
  rules.must_kick = true;
  rules.shot_allowed = false;
  const Kick kick = choose_kick(view, observer.observe(view), 1, rules, {}, {});
  ASSERT_EQ(kick.kind, Kick::Kind::Pass);
  EXPECT_GT(kick.angle, 0.5);
}

// ---- the tactic

Roles attack_roles() {
  Roles roles;
  roles.goalie = 0;
  roles.winner = 1;
  roles.role[0] = Role::Goalie;
  roles.role[1] = Role::Winner;
  roles.role[2] = roles.role[3] = roles.role[4] = Role::Support;
  return roles;
}

TEST(Supports, WithZonesEachHasAZoneOfItsOwnFromTheTable) {
  kit::View view = an_attack();
  Observer observer;
  Supports supports;
  supports.think(view, observer.observe(view), attack_roles(), {});
  const auto targets = supports.targets();
  ASSERT_EQ(targets.size(), 3u);
  const Zone ball = supports.partition().zone_of(view.ball.position);
  const ZoneList list = zones_for(ball, true);
  std::set<int> zones;
  for (const PassTarget& target : targets) {
    const Zone zone = supports.partition().zone_of(target.point);
    EXPECT_NE(std::find(list.begin(), list.begin() + 3, zone), list.begin() + 3);
    zones.insert(index_of(zone));
  }
  EXPECT_EQ(zones.size(), 3u);
}

TEST(Supports, GreedyTheyStandAMetreApart) {
  kit::View view = an_attack();
  Observer observer;
  Parameters parameters;
  parameters.attack = "greedy";
  Supports supports;
  supports.think(view, observer.observe(view), attack_roles(), parameters);
  const auto targets = supports.targets();
  ASSERT_EQ(targets.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < i; ++j) EXPECT_GE((targets[i].point - targets[j].point).norm(), 1.0);
  }
}

TEST(Supports, WaitsBesideThePlaceOfThePass) {
  kit::View view = an_attack();
  Observer observer;
  Supports supports;
  supports.think(view, observer.observe(view), attack_roles(), {});
  for (const PassTarget& target : supports.targets()) {
    const kit::Robot& robot = *kit::find(view.own, target.receiver);
    const skills::Order order = supports.play(view, robot);
    EXPECT_LE((order.target - target.point).norm(), 1.0) << "to be there in time";
    EXPECT_EQ(order.kick_speed, 0);
  }
}

// ---- set plays

kit::View restart(kit::Phase phase, const Vector2d& ball) {
  kit::View view = an_attack();
  view.ball.position = ball;
  view.game.phase = phase;
  view.game.ours = true;
  view.game.restart_position = ball;
  return view;
}

TEST(SetPlay, ACornerIsOursNearTheirGoalLineAndATouchLine) {
  EXPECT_EQ(set_play(restart(kit::Phase::DirectFree, {4.4, 2.9})), SetPlay::Corner);
  EXPECT_EQ(set_play(restart(kit::Phase::IndirectFree, {4.4, -2.9})), SetPlay::Corner);
  EXPECT_EQ(set_play(restart(kit::Phase::DirectFree, {2.0, 2.9})), SetPlay::None);
  EXPECT_EQ(set_play(restart(kit::Phase::Kickoff, {0, 0})), SetPlay::Kickoff);
  kit::View theirs = restart(kit::Phase::DirectFree, {4.4, 2.9});
  theirs.game.ours = false;
  EXPECT_EQ(set_play(theirs), SetPlay::None);
}

TEST(SetPlay, CornerPlacesAreLegalApartAndMirrored) {
  const kit::View left = restart(kit::Phase::DirectFree, {4.4, 2.9});
  const kit::View right = restart(kit::Phase::DirectFree, {4.4, -2.9});
  for (int i = 0; i < 3; ++i) {
    const auto place = set_play_place(left, i);
    ASSERT_TRUE(place);
    EXPECT_TRUE(may_wait_at(left, *place)) << i;
    EXPECT_LT((mirrored(*place) - *set_play_place(right, i)).norm(), 1e-12);
    for (int j = 0; j < i; ++j) EXPECT_GT((*place - *set_play_place(left, j)).norm(), 0.8);
  }
}

TEST(SetPlay, KickoffRunnersWaitInOurHalfAndGetTheBallInTheirs) {
  const kit::View view = restart(kit::Phase::Kickoff, {0, 0});
  for (int i = 0; i < 2; ++i) {
    const auto place = set_play_place(view, i);
    ASSERT_TRUE(place);
    EXPECT_LT(place->x(), -field.robot_radius);
    const Vector2d target = set_play_target(view, *place);
    // Forward enough that the kicker behind the ball stays in its half.
    EXPECT_GT(target.x(), 0.5 * target.norm());
  }
}

TEST(SetPlay, TheKickoffIsTappedForwardToTheRobotBesideTheBall) {
  const kit::View view = restart(kit::Phase::Kickoff, {0, 0});
  const Vector2d beside = *set_play_place(view, 0), wing = *set_play_place(view, 1);
  const std::array<PassTarget, 2> targets{PassTarget{3, set_play_target(view, wing)},
                                          PassTarget{2, set_play_target(view, beside)}};
  const auto tap = set_kick(view, targets);
  ASSERT_TRUE(tap);
  EXPECT_EQ(tap->receiver, 2);
  // The kicker behind the ball stays in its half, and the laws want the ball forward.
  EXPECT_GT(std::cos(tap->direction), 0.5);
  EXPECT_FALSE(set_kick(view, std::span(targets.data(), 1))) << "nobody beside it: as any restart";
  EXPECT_FALSE(set_kick(restart(kit::Phase::DirectFree, {0, 0}), targets));
}

TEST(SetPlay, AGoalKickIsOursNearOurGoalLine) {
  EXPECT_EQ(set_play(restart(kit::Phase::DirectFree, {-4.0, 2.9})), SetPlay::GoalKick);
  EXPECT_EQ(set_play(restart(kit::Phase::IndirectFree, {-3.6, -2.9})), SetPlay::GoalKick);
  EXPECT_EQ(set_play(restart(kit::Phase::DirectFree, {-2.0, 2.9})), SetPlay::None);
  kit::View theirs = restart(kit::Phase::DirectFree, {-4.0, 2.9});
  theirs.game.ours = false;
  EXPECT_EQ(set_play(theirs), SetPlay::None);
}

TEST(SetPlay, OurGoalKickNeverComesInFrontOfOurGoal) {
  for (const double side : {1.0, -1.0}) {
    const kit::View view = restart(kit::Phase::DirectFree, {-4.0, 2.9 * side});
    for (int i = 0; i < 3; ++i) {
      const Vector2d place = *set_play_place(view, i);
      EXPECT_LT(world::distance_outside_lines(field, place), -0.3);
      // A shooter's distance (the reference team's own shots promise little from farther).
      EXPECT_GT((place - view.own_goal()).norm(), 3.0);
    }
    const Kick kick = long_goal_kick(view);
    EXPECT_GT(std::cos(kick.direction), 0.8) << "upfield";
    EXPECT_LT(std::abs(kick.target.y()), field.half_width());
    EXPECT_GT(kick.target.y() * side, 0) << "on its own flank";
  }
}

TEST(SetPlay, ANeutralStartLastsUntilTheBallMoves) {
  kit::View view = running({1, 1});
  view.game.restart_position = view.ball.position;
  EXPECT_EQ(set_play(view), SetPlay::NeutralStart);
  const Vector2d cover = *set_play_place(view, 0);
  const world::Segment home{view.ball.position, view.own_goal()};
  EXPECT_LT(world::distance(home, cover), 1e-9);
  EXPECT_FALSE(set_play_place(view, 1)) << "one covers, the rest plays on";
  view.ball.position.x() += 0.1;
  EXPECT_EQ(set_play(view), SetPlay::None);
  view.ball.position = view.game.restart_position;
  view.game.forbidden = 3;
  EXPECT_EQ(set_play(view), SetPlay::None) << "a kick of ours is under way";
}

TEST(ChooseKick, WithTargetsOnlyNobodyElseGetsTheBall) {
  kit::View view = restart(kit::Phase::DirectFree, {-4.0, 2.9});
  view.own[1].position = {-4.05, 2.98};
  Observer observer;
  const Situation& situation = observer.observe(view);
  KickRules rules;
  rules.must_kick = true;
  rules.only_targets = true;
  rules.otherwise = long_goal_kick(view);
  const Kick kick = choose_kick(view, situation, 1, rules, {}, {});
  EXPECT_EQ(kick.kind, Kick::Kind::Clear);
  EXPECT_EQ(kick.direction, rules.otherwise->direction);
  view.opponents.resize(1);  // the goalkeeper: nobody in the way
  const std::array<PassTarget, 1> targets{PassTarget{3, *set_play_place(view, 0)}};
  view.own[3].position = targets[0].point;
  rules.targets = targets;
  EXPECT_EQ(choose_kick(view, situation, 1, rules, {}, {}).receiver, 3);
}

TEST(Penalty, GoesToTheSideTheGoalieIsFartherFrom) {
  kit::View view = restart(kit::Phase::Penalty, {3.5, 0});
  view.opponents[0].position = {4.48, 0.15};
  EXPECT_LT(penalty_direction(view), 0);
  view.opponents[0].position.y() = -0.15;
  EXPECT_GT(penalty_direction(view), 0);
  const double y = std::tan(penalty_direction(view)) * (field.half_length() - 3.5);
  EXPECT_LT(y, field.goal_width / 2 - field.ball_radius) << "inside the post";
}

}  // namespace
}  // namespace reference

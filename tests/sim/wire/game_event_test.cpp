#include <gmock/gmock.h>

#include <chrono>

#include "sim/wire/referee.h"
#include "tests/sim/wire/league_schema.h"

// Offences of 2015 that the league has dropped since.
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"

namespace {

using testing::IsEmpty;
using wire::Epoch;
using wire::proto::GameEvent;
using world::RobotId;
using world::Team;

const world::Time now{std::chrono::seconds{5}};
const world::Touch touch{RobotId{Team::Yellow, 7}, world::Time{std::chrono::seconds{4}}, {1, 2}, 1};

GameEvent encoded(decltype(world::GameEvent::what) what) {
  GameEvent out;
  EXPECT_TRUE(wire::encode({now, std::move(what)}, Epoch{}, out));
  EXPECT_THAT(league::missing_required(out, "ssl-game-controller HEAD"), IsEmpty());
  EXPECT_EQ(out.created_timestamp(), 1'700'000'005'000'000U);
  // The number of the body and the number of the type agree for all events that we have.
  EXPECT_EQ(static_cast<int>(out.event_case()), static_cast<int>(out.type()));
  return out;
}

}  // namespace

TEST(GameEvent, BallLeftFieldNamesTheLastToucher) {
  const GameEvent touch_line = encoded(world::BallLeftFieldTouchLine{touch, {1, 3}});
  EXPECT_EQ(touch_line.type(), GameEvent::BALL_LEFT_FIELD_TOUCH_LINE);
  EXPECT_EQ(touch_line.ball_left_field_touch_line().by_team(), matchday::referee::YELLOW);
  EXPECT_EQ(touch_line.ball_left_field_touch_line().by_bot(), 7U);
  EXPECT_EQ(touch_line.ball_left_field_touch_line().location().y(), 3.0F);  // metres

  const GameEvent goal_line = encoded(world::BallLeftFieldGoalLine{std::nullopt, {4.5, 2}});
  EXPECT_EQ(goal_line.type(), GameEvent::BALL_LEFT_FIELD_GOAL_LINE);
  EXPECT_EQ(goal_line.ball_left_field_goal_line().by_team(), matchday::referee::UNKNOWN);
  EXPECT_FALSE(goal_line.ball_left_field_goal_line().has_by_bot());
}

TEST(GameEvent, AGoalBelongsToTheOtherTeamThanTheDefenders) {
  const GameEvent goal = encoded(world::PossibleGoal{Team::Blue, touch, {4.5, 0.1}});
  EXPECT_EQ(goal.possible_goal().by_team(), matchday::referee::YELLOW);
  EXPECT_EQ(goal.possible_goal().kicking_team(), matchday::referee::YELLOW);
  EXPECT_EQ(goal.possible_goal().kicking_bot(), 7U);
  EXPECT_EQ(goal.possible_goal().last_touch_by_team(), 1'700'000'004'000'000U);

  const GameEvent own_goal = encoded(world::PossibleGoal{Team::Yellow, touch, {-4.5, 0.1}});
  EXPECT_EQ(own_goal.possible_goal().by_team(), matchday::referee::BLUE);
  EXPECT_EQ(own_goal.possible_goal().kicking_team(), matchday::referee::YELLOW);
  EXPECT_FALSE(own_goal.possible_goal().has_last_touch_by_team()) << "blue never touched it";
}

TEST(GameEvent, OffencesNameTheRobot) {
  const RobotId robot{Team::Blue, 3};
  const GameEvent fast = encoded(world::BotKickedBallTooFast{robot, {1, 1}, 9.5});
  EXPECT_EQ(fast.bot_kicked_ball_too_fast().by_team(), matchday::referee::BLUE);
  EXPECT_EQ(fast.bot_kicked_ball_too_fast().initial_ball_speed(), 9.5F);
  const GameEvent dribble = encoded(world::BotDribbledBallTooFar{robot, {0, 0}, {1.5, 0}});
  EXPECT_EQ(dribble.bot_dribbled_ball_too_far().by_bot(), 3U);
  EXPECT_EQ(dribble.bot_dribbled_ball_too_far().end().x(), 1.5F);
  const GameEvent twice = encoded(world::AttackerDoubleTouchedBall{robot, {2, 0}});
  EXPECT_EQ(twice.attacker_double_touched_ball().location().x(), 2.0F);
  const GameEvent stuck = encoded(world::NoProgressInGame{{0, 1}, std::chrono::seconds{10}});
  EXPECT_EQ(stuck.no_progress_in_game().time(), 10.0F);
}

TEST(GameEvent, OffencesOfLaw12CarryTheirMeasures) {
  const RobotId robot{Team::Blue, 3};
  const RobotId other{Team::Yellow, 5};
  const GameEvent icing = encoded(world::AimlessKick{robot, {-4.5, 1}, {2, 0}});
  EXPECT_EQ(icing.aimless_kick().location().x(), -4.5F);
  EXPECT_EQ(icing.aimless_kick().kick_location().x(), 2.0F);
  const GameEvent chip = encoded(world::ChippedGoal{robot, {-4.5, 0}, {2, 0}, 0.5});
  EXPECT_EQ(chip.chipped_goal().max_ball_height(), 0.5F);
  const GameEvent unique = encoded(world::BotCrashUnique{robot, other, {1, 2}, 2.5, 0.75, 1.5, false});
  EXPECT_EQ(unique.bot_crash_unique().by_team(), matchday::referee::BLUE);
  EXPECT_EQ(unique.bot_crash_unique().violator(), 3U);
  EXPECT_EQ(unique.bot_crash_unique().victim(), 5U);
  EXPECT_EQ(unique.bot_crash_unique().crash_speed(), 2.5F);
  EXPECT_EQ(unique.bot_crash_unique().speed_diff(), 0.75F);
  EXPECT_EQ(unique.bot_crash_unique().crash_angle(), 1.5F);
  const GameEvent drawn = encoded(world::BotCrashDrawn{{other, robot}, {1, 2}, 2.5, 0.25, 1.5});
  EXPECT_EQ(drawn.bot_crash_drawn().bot_yellow(), 5U);
  EXPECT_EQ(drawn.bot_crash_drawn().bot_blue(), 3U);
  const GameEvent goalie = encoded(world::AttackerTouchedKeeper{robot, other, {-4, 0}});
  EXPECT_EQ(goalie.attacker_touched_opponent_in_defense_area().by_bot(), 3U);
  EXPECT_EQ(goalie.attacker_touched_opponent_in_defense_area().victim(), 5U);
  const GameEvent wholly = encoded(world::DefenderInDefenseArea{robot, {4, 0}, 0.25, true});
  EXPECT_EQ(wholly.defender_in_defense_area().distance(), 0.25F);
  const GameEvent partly = encoded(world::DefenderInDefenseArea{robot, {4, 0}, 0.125, false});
  EXPECT_EQ(partly.defender_in_defense_area_partially().distance(), 0.125F);
  const GameEvent attacker = encoded(world::AttackerTouchedBallInDefenseArea{robot, {-4, 0}, {-4, 0.1}, 0.5});
  EXPECT_EQ(attacker.attacker_touched_ball_in_defense_area().distance(), 0.5F);
  const GameEvent held = encoded(world::KeeperHeldBall{robot, {4, 0}, std::chrono::seconds{15}});
  EXPECT_EQ(held.keeper_held_ball().duration(), 15.0F);
  const GameEvent fast = encoded(world::BotTooFastInStop{robot, {1, 0}, 2.0});
  EXPECT_EQ(fast.bot_too_fast_in_stop().speed(), 2.0F);
  const GameEvent in_the_way = encoded(world::BotInterferedPlacement{robot, {1, 0}});
  EXPECT_EQ(in_the_way.bot_interfered_placement().by_bot(), 3U);
  const GameEvent many = encoded(world::TooManyRobots{Team::Blue, 7, 6});
  EXPECT_EQ(many.too_many_robots().num_robots_on_field(), 7);
  EXPECT_EQ(many.too_many_robots().num_robots_allowed(), 6);

  world::KickTaken kick;
  kick.opponent_near_ball = robot;
  EXPECT_EQ(encoded(kick).defender_too_close_to_kick_point().by_bot(), 3U);
  kick.attacker_near_area = other;
  EXPECT_EQ(encoded(kick).attacker_too_close_to_defense_area().by_bot(), 5U);
}

TEST(GameEvent, ThePapersOwnEventsAreNotTheLeagues) {
  GameEvent out;
  out.set_id("left over");
  EXPECT_FALSE(wire::encode({now, world::BallTouched{touch}}, Epoch{}, out));
  EXPECT_EQ(out.ByteSizeLong(), 0U);
  EXPECT_FALSE(wire::encode({now, world::KickTaken{}}, Epoch{}, out));
  EXPECT_FALSE(wire::encode({now, world::RobotsSettled{}}, Epoch{}, out));
  EXPECT_FALSE(wire::encode({now, world::BotTooNearInStop{}}, Epoch{}, out));
  EXPECT_FALSE(wire::encode({now, world::BotLeftField{}}, Epoch{}, out));
}

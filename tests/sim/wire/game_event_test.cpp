#include <gmock/gmock.h>

#include <chrono>

#include "sim/wire/referee.h"
#include "tests/sim/wire/league_schema.h"

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

TEST(GameEvent, ThePapersOwnEventsAreNotTheLeagues) {
  GameEvent out;
  out.set_id("left over");
  EXPECT_FALSE(wire::encode({now, world::BallTouched{touch}}, Epoch{}, out));
  EXPECT_EQ(out.ByteSizeLong(), 0U);
  EXPECT_FALSE(wire::encode({now, world::KickTaken{}}, Epoch{}, out));
  EXPECT_FALSE(wire::encode({now, world::RobotsSettled{}}, Epoch{}, out));
}

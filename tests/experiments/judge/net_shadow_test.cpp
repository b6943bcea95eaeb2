// Outside autorefs: what they report, and a whole short game with one that listens on the network.
#include "experiments/judge/net/net_shadow.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "autoref/referee/referee.h"
#include "experiments/host/match.h"
#include "experiments/judge/game.h"
#include "experiments/judge/net/namespace.h"
#include "experiments/judge/net/reported.h"
#include "sim/wire/epoch.h"
#include "tests/fakes/games.h"
#include "tests/fakes/programs.h"

namespace judge {
namespace {

namespace proto = matchday::referee;
using testing::HasSubstr;

world::Time at(double seconds) { return world::Time{world::from_seconds(seconds)}; }

proto::GameEvent exit_by(proto::Team team, std::uint32_t robot) {
  proto::GameEvent event;
  auto& left = *event.mutable_ball_left_field_touch_line();
  left.set_by_team(team);
  left.set_by_bot(robot);
  left.mutable_location()->set_x(1);
  left.mutable_location()->set_y(-3);
  return event;
}

TEST(Reported, ExitsSayWhoAndWhere) {
  proto::GameEvent event = exit_by(proto::BLUE, 4);
  event.set_created_timestamp(static_cast<std::uint64_t>(wire::to_microseconds(at(99.5), wire::Epoch{})));
  const auto call = call_of(event, at(100));
  ASSERT_TRUE(call);
  EXPECT_EQ(call->event, Event::Exit);
  EXPECT_EQ(call->time, at(99.5));
  EXPECT_EQ(call->reported, at(100));
  EXPECT_EQ(call->last->robot, (world::RobotId{world::Team::Blue, 4}));
  EXPECT_EQ(call->place, world::Vector2d(1, -3));
}

// Else the game's result could not be read back: JSON has no such numbers.
TEST(Reported, APlaceThatIsNoneIsNotTaken) {
  proto::GameEvent event = exit_by(proto::BLUE, 4);
  for (const float x : {std::nanf(""), HUGE_VALF, 1e9F}) {
    event.mutable_ball_left_field_touch_line()->mutable_location()->set_x(x);
    EXPECT_EQ(call_of(event, at(100))->place, world::Vector2d::Zero()) << x;
  }
}

TEST(Reported, AnotherClockCountsAsNow) {
  proto::GameEvent event = exit_by(proto::YELLOW, 1);
  EXPECT_EQ(call_of(event, at(100))->time, at(100));  // says nothing
  for (const double other : {100.5, 80.0}) {          // later than now, long ago
    event.set_created_timestamp(static_cast<std::uint64_t>(wire::to_microseconds(at(other), wire::Epoch{})));
    EXPECT_EQ(call_of(event, at(100))->time, at(100)) << other;
  }
  event.set_created_timestamp(~std::uint64_t{0});
  EXPECT_EQ(call_of(event, at(100))->time, at(100));
}

TEST(Reported, GoalsAndCrashesAndWhatIsNoCall) {
  proto::GameEvent goal;
  goal.mutable_possible_goal()->set_by_team(proto::BLUE);
  EXPECT_EQ(call_of(goal, at(1))->event, Event::Goal);
  proto::GameEvent crash;
  crash.mutable_bot_crash_unique()->set_by_team(proto::YELLOW);
  crash.mutable_bot_crash_unique()->set_violator(3);
  EXPECT_EQ(call_of(crash, at(1))->by, (world::RobotId{world::Team::Yellow, 3}));
  proto::GameEvent placed;
  placed.mutable_placement_succeeded()->set_by_team(proto::BLUE);
  EXPECT_FALSE(call_of(placed, at(1)));
  EXPECT_FALSE(call_of({}, at(1)));
}

TEST(ParseShadow, ReadsOutsideAutorefs) {
  const ShadowConfig real_time = parse_shadow("net:autoref --gc, x=1");
  EXPECT_EQ(real_time.command, "autoref --gc, x=1");
  EXPECT_EQ(real_time.net_speed, 1);
  EXPECT_EQ(parse_shadow("net@2.5:autoref").net_speed, 2.5);
  for (const char* bad : {"net:", "net: ", "net@2", "net@x:autoref", "net@0:autoref"}) {
    EXPECT_THROW(parse_shadow(bad), std::invalid_argument) << bad;
  }
}

class OutsideAutoref : public ::testing::Test {
 protected:
  void SetUp() override {
    try {
      check_network_namespace();
    } catch (const std::invalid_argument& error) {
      GTEST_SKIP() << error.what();
    }
    config_.half_length = 5;
  }
  record::MatchConfig config_ = fakes::short_game("wander", "wander");
};

TEST_F(OutsideAutoref, IsHeardAndChangesNothing) {
  const record::MatchRecord alone = host::play(config_);
  // Ten times as fast as real: its packets come every 1.7 ms, which is what such a
  // program can take under load.
  const std::string name = "net@20:" + fakes::bin_dir() + "/fake-autoref";
  const GameResult judged = play_judged({"it", config_, {parse_shadow(name)}});
  EXPECT_EQ(judged.fault, "");
  EXPECT_EQ(judged.hash, alone.hash);
  ASSERT_EQ(judged.shadows.back(), name);
  for (const Case& one : judged.cases) {
    EXPECT_TRUE(one.shadow != name || can_be_reported(one.event)) << judge::name(one.event);
  }
}

TEST_F(OutsideAutoref, ReportsAnExit) {
  referee::Setup setup;
  setup.rules = host::rules_of(config_);
  const engine::Model model = host::model_of(config_);
  setup.geometry = model.geometry;
  engine::Engine engine(model);
  referee::Referee referee(setup);
  // Half the real pace: on a loaded machine the program still keeps up.
  NetShadow outside("it", fakes::bin_dir() + "/fake-autoref", 0.5, model.geometry, setup.rules);
  std::optional<world::Time> out;
  const auto ticks = [&](int count) {
    for (int n = 0; n < count; ++n) {
      engine.step({});
      referee.update(engine.detections(), engine.time());
      outside.tick(engine, referee);
      const double edge = setup.rules.field.half_width() + setup.rules.field.ball_radius;
      if (!out && engine.truth().ball.position.y() > edge) out = engine.time();
    }
  };
  const world::RobotId kicker{world::Team::Blue, 2};
  engine.put_robot(kicker, {0.0, 2.6}, std::numbers::pi / 2);
  engine.place_ball({0.0, 2.71});  // touching
  ticks(10);
  ASSERT_EQ(referee.overrule({"test", "play", referee::SetStage{world::Stage::First}}), "");
  ticks(2);
  ASSERT_EQ(referee.overrule({"test", "play", referee::ForceCommand{{world::CommandKind::Start}}}), "");
  ticks(10);
  ASSERT_EQ(referee.state().location, world::Location::GameOn);
  truth::Ball kicked = engine.truth().ball;
  kicked.velocity = {0, 3, 0};
  engine.put_ball(kicked);
  ticks(60);
  outside.end();
  ASSERT_TRUE(out);
  ASSERT_EQ(outside.calls().size(), 1u);
  const Call& call = outside.calls().front();
  EXPECT_EQ(call.event, Event::Exit);
  EXPECT_EQ(call.last->robot, kicker);
  EXPECT_FALSE(call.late);
  EXPECT_NEAR(world::seconds(call.time), world::seconds(*out), 0.05);  // three images, and the noise
}

TEST_F(OutsideAutoref, SaysWhenTheProgramEnds) {
  const GameResult judged = play_judged({"it", config_, {parse_shadow("net@10:exit 3")}});
  EXPECT_THAT(judged.fault, HasSubstr("ended with code 3 before it registered at port 10007"));
}

}  // namespace
}  // namespace judge

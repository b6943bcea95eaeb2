#include <gtest/gtest.h>

#include "teams/kit/looker.h"
#include "tests/teams/support/views.h"

namespace kit {
namespace {

using world::Team;

Setup setup_for(Team team) {
  Setup setup;
  setup.team = team;
  setup.vision_delay = 1;
  setup.command_latency = 1;
  for (std::uint8_t number = 0; number < 3; ++number) {
    world::RobotSpecs specs;
    specs.id = {team, number};
    setup.robots.push_back(world::slowed(specs, 0.5));
  }
  return setup;
}

world::TrackedRobot tracked(Team team, std::uint8_t number, Vector2d position, double orientation = 0,
                            Vector2d velocity = {0, 0}) {
  world::TrackedRobot robot;
  robot.id = {team, number};
  robot.position = position;
  robot.orientation = orientation;
  robot.velocity = velocity;
  return robot;
}

world::TrackedFrame frame_at(world::Time time) {
  world::TrackedFrame frame;
  frame.time = time;
  frame.ball.emplace();
  frame.ball->position = {1, 0.5, 0};
  frame.ball->velocity = {0.5, -1, 0};
  frame.robots = {tracked(Team::Yellow, 1, {-1, 0.2}, 0.3, {1, 0}),
                  tracked(Team::Blue, 2, {2, 1}, -2, {0, 1})};
  return frame;
}

world::RefereeMessage message_of(world::CommandKind kind, Team team = Team::Yellow,
                                 std::uint32_t counter = 1) {
  world::RefereeMessage message;
  message.command = {kind, team};
  message.command_counter = counter;
  message.command_time = world::tick_time(100);
  message.blue_on_positive_half = true;
  message.designated_position = Vector2d(1, 2);
  return message;
}

TEST(Looker, ShowsBothTeamsTheSameWorldTurnedByHalfATurn) {
  const world::TrackedFrame frame = frame_at(world::tick_time(99));
  const world::RefereeMessage message = message_of(world::CommandKind::Start);
  Looker yellow(setup_for(Team::Yellow));
  Looker blue(setup_for(Team::Blue));
  const View& a = yellow.look(100, frame, message, {});
  const View& b = blue.look(100, frame, message, {});

  EXPECT_LT((a.ball.position + b.ball.position).norm(), 1e-12);
  EXPECT_LT((a.ball.velocity + b.ball.velocity).norm(), 1e-12);
  EXPECT_EQ(*a.game.designated_position, Vector2d(1, 2));
  EXPECT_EQ(*b.game.designated_position, Vector2d(-1, -2));
  ASSERT_EQ(a.own.size(), 1u);
  ASSERT_EQ(b.opponents.size(), 1u);
  EXPECT_EQ(a.own[0].number, 1);
  EXPECT_EQ(b.opponents[0].number, 1);
  EXPECT_NEAR(world::wrap_angle(a.own[0].orientation - b.opponents[0].orientation - M_PI), 0, 1e-12);
}

TEST(Looker, FollowsTheChangeOfEnds) {
  const world::TrackedFrame frame = frame_at(world::tick_time(99));
  world::RefereeMessage message = message_of(world::CommandKind::Start);
  Looker yellow(setup_for(Team::Yellow));
  const Vector2d before = yellow.look(100, frame, message, {}).ball.position;
  message.blue_on_positive_half = false;
  EXPECT_LT((yellow.look(101, frame_at(world::tick_time(100)), message, {}).ball.position + before).norm(),
            1e-12);
}

TEST(Looker, CarriesTheBallForwardToWhenTheAnswerTakesEffect) {
  // Seen at tick 99, answered at tick 100, in effect from tick 101: 2/60 s later.
  Looker yellow(setup_for(Team::Yellow));
  const View& view =
      yellow.look(100, frame_at(world::tick_time(99)), message_of(world::CommandKind::Start), {});
  const Vector2d velocity(0.5, -1);
  const double speed = velocity.norm(), t = 2.0 / 60;
  // A ball never seen before counts as sliding: 3 m/s^2. 1e-9: nanoseconds of rounding in the instants.
  const Vector2d expected = Vector2d(1, 0.5) + velocity / speed * (speed * t - 1.5 * t * t);
  EXPECT_LT((view.ball.position - expected).norm(), 1e-8);
}

TEST(Looker, CarriesOwnRobotsForwardWithTheCommandsSent) {
  Looker yellow(setup_for(Team::Yellow));
  world::TrackedFrame frame;
  frame.robots = {tracked(Team::Yellow, 1, {0, 0})};
  world::RobotCommand command;
  command.number = 1;
  command.velocity_local = {0.01, 0};  // reached at once
  for (int tick = 100; tick < 106; ++tick) {
    frame.time = world::tick_time(tick - 1);
    yellow.look(tick, frame, message_of(world::CommandKind::Start), {});
    yellow.sent({command});
  }
  frame.time = world::tick_time(105);
  const View& view = yellow.look(106, frame, message_of(world::CommandKind::Start), {});
  // Two ticks under a known command; the first begins from the tracker's zero.
  EXPECT_NEAR(view.own[0].velocity.x(), 0.01, 1e-9);
  EXPECT_NEAR(view.own[0].position.x(), 0.01 * 1.5 / 60, 1e-9);
}

TEST(Looker, GivesOwnRobotsTheirTrueLimits) {
  Looker yellow(setup_for(Team::Yellow));
  const View& view =
      yellow.look(100, frame_at(world::tick_time(99)), message_of(world::CommandKind::Start), {});
  EXPECT_EQ(view.own[0].specs.max_speed, 1.5);
  EXPECT_EQ(view.opponents[0].specs.max_speed, 3.0);
}

class Reading : public testing::Test {
 protected:
  // One message later, with the ball there.
  void read(world::CommandKind kind, Team team, const Vector2d& ball, int frames = 1) {
    if (kind != last_ || team != last_team_) ++counter_;
    last_ = kind;
    last_team_ = team;
    for (int i = 0; i < frames; ++i) {
      view_.ball.position = ball;
      view_.ball.known = true;
      reader_.update(message_of(kind, team, counter_), view_, view_.game);
    }
  }
  GameReader reader_{Team::Yellow, 0.0215};
  View view_ = support::running({0, 0});
  world::CommandKind last_ = world::CommandKind::Halt;
  Team last_team_ = Team::Yellow;
  std::uint32_t counter_ = 1;
};

TEST_F(Reading, SaysWhoseKickItIs) {
  read(world::CommandKind::Direct, Team::Yellow, {0, 0});
  EXPECT_EQ(view_.game.phase, Phase::DirectFree);
  EXPECT_TRUE(view_.game.ours);
  read(world::CommandKind::Indirect, Team::Blue, {0, 0});
  EXPECT_EQ(view_.game.phase, Phase::IndirectFree);
  EXPECT_FALSE(view_.game.ours);
}

TEST_F(Reading, AKickoffIsPreparedThenTakenThenInPlay) {
  read(world::CommandKind::Kickoff, Team::Yellow, {0, 0});
  EXPECT_EQ(view_.game.phase, Phase::PrepareKickoff);
  read(world::CommandKind::Ready, Team::Yellow, {0, 0});
  EXPECT_EQ(view_.game.phase, Phase::Kickoff);
  EXPECT_TRUE(view_.game.ours);
  read(world::CommandKind::Ready, Team::Yellow, {0.2, 0}, 3);
  EXPECT_EQ(view_.game.phase, Phase::Running);
}

TEST_F(Reading, TheKickerMustNotTouchAgainUntilAnotherRobotDid) {
  support::put(view_.own, 1, {-0.1, 0});
  support::put(view_.own, 2, {3, 0});
  read(world::CommandKind::Indirect, Team::Yellow, {0, 0});
  read(world::CommandKind::Indirect, Team::Yellow, {0.2, 0}, 3);
  EXPECT_EQ(view_.game.phase, Phase::Running);
  EXPECT_EQ(view_.game.forbidden, 1);
  EXPECT_TRUE(view_.game.indirect);
  view_.own[1].ball_contact = true;
  read(world::CommandKind::Indirect, Team::Yellow, {2.9, 0}, 1);
  EXPECT_FALSE(view_.game.forbidden.has_value());
  EXPECT_FALSE(view_.game.indirect);
}

TEST_F(Reading, ANeutralStartIsRunningForBoth) {
  read(world::CommandKind::Stop, Team::Yellow, {0, 0});
  EXPECT_EQ(view_.game.phase, Phase::Stop);
  read(world::CommandKind::Start, Team::Yellow, {0, 0});
  EXPECT_EQ(view_.game.phase, Phase::Running);
  EXPECT_FALSE(view_.game.ours);
}

TEST_F(Reading, AGoalIsObeyedLikeAStop) {
  read(world::CommandKind::Goal, Team::Blue, {0, 0});
  EXPECT_EQ(view_.game.phase, Phase::Stop);
}

}  // namespace
}  // namespace kit

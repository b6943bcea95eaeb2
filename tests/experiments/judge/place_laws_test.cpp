// The truth's own laws on truth written by hand, of places and times: stops, settling, limits.
#include <gtest/gtest.h>

#include "experiments/judge/laws/laws.h"
#include "tests/experiments/judge/story.h"

namespace judge {
namespace {

using world::Location;

// Positions are sums of 1/60 s steps: far below this [m, s, bands].
constexpr double exact = 1e-6;

TEST(Stops, KnowASpeedOnlyWhenItLasts) {
  for (const int ticks : {30, 12}) {  // half a second and a fifth; the limit is 0.3 s
    Story story;
    story.enter(Location::GameOff);
    story.state.command = {world::CommandKind::Stop, world::Team::Yellow};
    story.robot(blue(2), {-3, 2});
    story.tick(150);  // the grace of 2 s is over
    story.robot(blue(2)).velocity = {1.9, 0};
    story.tick(ticks);
    story.robot(blue(2)).velocity.setZero();
    story.tick(30);
    story.enter(Location::GameOn);
    story.tick(2);
    const auto fast = story.told(Event::TooFastInStop);
    ASSERT_EQ(fast.size(), ticks == 30 ? 1u : 0u);
    if (ticks == 30) {
      EXPECT_NEAR(fast[0].margin, 0.4 / 0.2, exact);
    }
  }
}

TEST(Stops, KnowWhoStaysNearAndInTheWay) {
  Story story;
  story.enter(Location::GameOff);
  story.state.command = {world::CommandKind::Stop, world::Team::Yellow};
  story.state.reset_position = world::Vector2d{2, 0};
  story.robot(blue(2), {0, 0.53});    // hull 0.44 m from the ball, on the way's beginning
  story.robot(yellow(1), {1, 0.57});  // hull 0.48 m from the way, 0.97 m from the ball
  story.robot(yellow(2), {1, -0.8});
  story.tick(200);
  story.enter(Location::GameOn);
  story.tick(2);
  const auto near = story.told(Event::TooNearInStop);
  ASSERT_EQ(near.size(), 1u);
  EXPECT_EQ(near[0].by, blue(2));
  EXPECT_NEAR(near[0].margin, 0.06 / 0.04, exact);
  const auto way = story.told(Event::InterferedPlacement);
  ASSERT_EQ(way.size(), 2u);
  EXPECT_EQ(way[0].by, yellow(1));
  EXPECT_NEAR(way[0].margin, 0.02 / 0.04, exact);
  EXPECT_EQ(way[1].by, blue(2));
}

TEST(RobotsOff, StayedOutsideForAllOfTheTime) {
  for (const int ticks : {130, 110}) {  // the limit is 2 s
    Story story;
    story.robot(blue(2), {0, 3.35});
    story.tick(ticks);
    story.robot(blue(2)).position.y() = 3.0;
    story.tick(2);
    EXPECT_EQ(story.told(Event::RobotLeftField).size(), ticks == 130 ? 1u : 0u);
  }
}

TEST(RobotsOff, AreToldOnceUntilTheyAreBack) {
  Story story;
  story.robot(blue(2), {0, 3.35});
  for (int passage = 0; passage < 3; ++passage) {
    story.tick(130);
    story.enter(Location::GameOff);
    story.tick(5);
    story.enter(Location::GameOn);
    if (passage == 1) {
      story.robot(blue(2)).position.y() = 3.0;
      story.tick();
      story.robot(blue(2)).position.y() = 3.35;
    }
  }
  story.tick();
  EXPECT_EQ(story.told(Event::RobotLeftField).size(), 2u);
}

TEST(RobotsOff, CountsThoseThatMayPlay) {
  Story story;
  story.state.red_cards.blue = 1;
  story.enter(Location::GameOn);
  for (int n = 0; n < 6; ++n) story.robot(blue(n), {0.3 * n, 1});
  story.tick(200);
  const auto many = story.told(Event::TooManyRobots);
  ASSERT_EQ(many.size(), 1u);
  EXPECT_EQ(many[0].by->team, world::Team::Blue);
}

TEST(Progress, IsAQuarterOfAMetreInAnySecond) {
  Story stuck;
  stuck.tick(12 * 60 + 5);
  ASSERT_EQ(stuck.told(Event::NoProgress).size(), 1u);
  EXPECT_NEAR(stuck.told(Event::NoProgress)[0].margin, 0.25 / 0.04, exact);
  Story rolls;
  rolls.ball.velocity = {0.26, 0, 0};
  rolls.tick(12 * 60 + 5);
  for (const TrueEvent& event : rolls.told(Event::NoProgress)) EXPECT_FALSE(event.happened());
}

TEST(KeeperHolds, NearlyTooLongWhenTheGameEnds) {
  Story story;
  story.state.keeper = {0, 0};
  story.robot(blue(0), {4.2, 0}).orientation = 3.14159265358979323846;
  story.ball.position = {4.2 - 0.0945, 0, Story::radius};
  story.tick(15 * 60 - 6);  // 0.1 s and a tick are missing
  story.end();
  const auto held = story.told(Event::KeeperHeldBall);
  ASSERT_EQ(held.size(), 1u);
  EXPECT_NEAR(held[0].margin, -(0.1 + world::tick_length) / 0.2, exact);
}

TEST(Progress, WasNearlyMissingWhenTheBallIsPlayedJustInTime) {
  const auto played_after = [](int ticks) {
    Story story;
    story.tick(ticks);
    story.ball.velocity = {3, 0, 0};
    story.tick(30);
    return story.told(Event::NoProgress);
  };
  const auto nearly = played_after(12 * 60 - 20);
  ASSERT_EQ(nearly.size(), 1u);
  // Seven ticks until it is a third of a metre away.
  EXPECT_NEAR(nearly[0].margin, -13.0 / 60 / 0.2, 1.5 / 60 / 0.2);  // ticks are told by their time
  EXPECT_TRUE(played_after(12 * 60 - 40).empty());
}

TEST(Progress, IsNotMadeByABallThatIsOut) {
  Story story;
  story.ball.position = {0, 2.9, Story::radius};
  story.ball.velocity = {0, 1, 0};
  story.tick(30);  // out after 0.14 s; nobody has said so
  story.ball.velocity = {0.5, 0, 0};
  story.tick(12 * 60 + 50);
  const auto stuck = story.told(Event::NoProgress);
  ASSERT_EQ(stuck.size(), 1u);
  EXPECT_TRUE(stuck[0].late);  // counts only where somebody called it, whenever
  EXPECT_GT(stuck[0].until, stuck[0].time);
}

TEST(Progress, IsNobodysFaultShortlyBeforeItIsMissing) {
  Story story;
  story.ball.velocity = {0.3, 0, 0};  // nearly none
  story.tick(6 * 60);
  story.ball.velocity.setZero();
  story.tick(11 * 60 + 10);
  story.enter(Location::GameOff);
  story.tick(30);
  const auto told = story.told(Event::NoProgress);
  ASSERT_EQ(told.size(), 2u);
  EXPECT_TRUE(told[1].close());
}

TEST(Laws, TellWhatGoesOnWhenTheGameEnds) {
  Story story;
  story.robot(blue(2), {0, 3.36});
  story.tick(12 * 60 - 5);
  EXPECT_TRUE(story.told(Event::RobotLeftField).empty());
  story.end();
  EXPECT_EQ(story.told(Event::RobotLeftField).size(), 1u);
  const auto stuck = story.told(Event::NoProgress);  // whoever calls it is not wrong
  ASSERT_EQ(stuck.size(), 1u);
  EXPECT_TRUE(stuck[0].close());
}

TEST(Progress, IsNoMatterWhileTheGoalieHoldsTheBall) {
  Story story;
  story.state.keeper = {0, 0};
  story.robot(blue(0), {4.2, 0}).orientation = 3.14159265358979323846;
  story.ball.position = {4.2 - 0.0945, 0, Story::radius};
  story.tick(16 * 60);
  EXPECT_TRUE(story.told(Event::NoProgress).empty());
  const auto held = story.told(Event::KeeperHeldBall);
  ASSERT_EQ(held.size(), 1u);
  EXPECT_EQ(held[0].by, blue(0));
}

TEST(Settling, NeedsASecondOfSlowRobots) {
  Story story;
  story.enter(Location::GameOff);
  story.state.reset_position = world::Vector2d{0, 0};
  story.robot(blue(2), {-1, 2}, {0.7, 0});
  story.tick(60);
  const double slow = story.now();
  story.robot(blue(2)).velocity.setZero();
  story.tick(70);
  story.enter(Location::Setup);
  story.tick(30);
  const auto settled = story.told(Event::RobotsSettled);
  ASSERT_EQ(settled.size(), 1u);
  EXPECT_NEAR(world::seconds(settled[0].time), slow + 1, 1.0 / 60 + exact);  // counted in ticks
  EXPECT_GE(settled[0].margin, 1);
}

/// Waits with a robot that drives in a circle at that speed, and a ball that lies that far from its place.
/// @return when the robots had settled [s] after the wait began; nothing: it was not told
std::optional<TrueEvent> wait(double speed, double off, bool kickoff = false, double x = -1,
                              int ticks = 2000) {
  Story story;
  story.enter(Location::GameOff);
  story.state.reset_position = world::Vector2d{off, 0};
  story.state.is_kickoff = kickoff;
  truth::Robot& robot = story.robot(yellow(2), {x, 2});
  for (int n = 0; n < ticks; ++n) {
    robot.velocity = speed * world::direction(0.05 * n);
    story.tick();
  }
  story.enter(Location::Setup);
  story.tick(30);
  const auto told = story.told(Event::RobotsSettled);
  if (told.empty()) return std::nullopt;
  return told[0];
}

double after_wait(const TrueEvent& event) { return world::seconds(event.time) - world::tick_length; }

TEST(Settling, KnowsTheLimitOfSpeedWithItsBand) {
  // Slower than 0.3 m/s, by a band below 0.4, and faster than 0.5.
  const auto slow = wait(0.29, 0);
  ASSERT_TRUE(slow);
  EXPECT_GE(slow->margin, 1);
  EXPECT_NEAR(after_wait(*slow), 1, 2 * world::tick_length);
  const auto fast = wait(0.52, 0);
  ASSERT_TRUE(fast);
  EXPECT_GE(fast->margin, 1);
  EXPECT_NEAR(after_wait(*fast), 15, 2 * world::tick_length) << "the wait is over";
  for (const double about : {0.36, 0.44}) {
    const auto close = wait(about, 0);
    ASSERT_TRUE(close);
    EXPECT_TRUE(close->close()) << about;
    EXPECT_NEAR(after_wait(*close), 1, 2 * world::tick_length) << "the first that is right";
    ASSERT_TRUE(close->until);
    EXPECT_NEAR(world::seconds(*close->until) - world::tick_length, 15, 2 * world::tick_length);
  }
}

TEST(Settling, NeedsTheBallInItsPlace) {
  EXPECT_NEAR(after_wait(*wait(0, 0.025)), 1, 2 * world::tick_length);  // 50 mm less a band of 20 mm
  EXPECT_NEAR(after_wait(*wait(0, 0.075)), 15, 2 * world::tick_length);
  EXPECT_TRUE(wait(0, 0.055)->close());
}

TEST(Settling, WaitsTwiceAsLongForRobotsInTheWrongHalf) {
  // Yellow defends -x.
  EXPECT_NEAR(after_wait(*wait(0, 0, true, -0.05)), 1, 2 * world::tick_length);
  EXPECT_NEAR(after_wait(*wait(0, 0, true, 0.05)), 30, 2 * world::tick_length);
  EXPECT_NEAR(after_wait(*wait(0, 0, false, 0.05)), 1, 2 * world::tick_length) << "only at a kickoff";
  EXPECT_TRUE(wait(0, 0, true, 0.02)->close());
}

TEST(Settling, IsNotToldWhenPlayGoesOnBefore) { EXPECT_FALSE(wait(0.2, 0, false, -1, 30)); }

// The numbers of the laws, each with a scene a little on either side of it: moved, one of them fails.
TEST(Limits, OfTimeAreThoseOfTheLaws) {
  const auto held = [](double seconds) {
    Story story;
    story.state.keeper = {0, 0};
    story.robot(blue(0), {4.2, 0}).orientation = 3.14159265358979323846;
    story.ball.position = {4.2 - 0.0945, 0, Story::radius};
    story.tick(static_cast<int>(seconds * 60));
    story.ball.position.x() = 4.2 - 0.14;  // lets go: 45 mm in front of it
    story.tick(40);
    const auto told = story.told(Event::KeeperHeldBall);
    return !told.empty() && told[0].happened();
  };
  EXPECT_FALSE(held(14.9));
  EXPECT_TRUE(held(15.1));

  const auto stuck = [](double seconds, double speed) {
    Story story;
    story.enter(Location::GameOn);
    story.ball.velocity = {speed, 0, 0};
    story.tick(static_cast<int>(seconds * 60));
    const auto told = story.told(Event::NoProgress);
    return std::ranges::any_of(told, [](const TrueEvent& one) { return one.happened(); });
  };
  EXPECT_FALSE(stuck(11.9, 0));
  EXPECT_TRUE(stuck(12.1, 0));
  EXPECT_TRUE(stuck(13.5, 0.24));
  EXPECT_FALSE(stuck(13.5, 0.26));

  const auto seven = [](double seconds) {
    Story story;
    story.enter(Location::GameOn);
    for (int n = 0; n < 7; ++n) story.robot(blue(n), {0.3 * n, 1});
    story.tick(static_cast<int>(seconds * 60));
    return !story.told(Event::TooManyRobots).empty();
  };
  EXPECT_FALSE(seven(1.9));
  EXPECT_TRUE(seven(2.1));
}

TEST(Limits, OfPlacesAndSpeedsAreThoseOfTheLaws) {
  const auto out = [](double y) {
    Story story;
    story.robot(blue(2), {0, y});
    story.tick(130);
    story.robot(blue(2)).position.y() = 2;
    story.tick(2);
    const auto told = story.told(Event::RobotLeftField);
    return !told.empty() && told[0].happened();
  };
  EXPECT_FALSE(out(3.24));  // of the centre: 0.25 m beyond the touch line
  EXPECT_TRUE(out(3.26));

  // Margins say which limit they are measured from.
  Story story;
  story.enter(Location::Setup);
  story.state.kick_team = world::Team::Yellow;
  story.state.is_kickoff = true;
  story.robot(yellow(1), {-0.0945, 0});
  story.robot(yellow(2), {0.03, 2});
  story.tick(3);
  story.touch(yellow(1));
  story.ball.velocity = {3, 0, 0};
  story.tick(3);
  story.enter(Location::GameOn);
  story.tick(25);
  const auto half = story.told(Event::WrongHalf);
  ASSERT_EQ(half.size(), 1u);
  EXPECT_EQ(half[0].by, yellow(2));
  EXPECT_NEAR(half[0].margin, 0.03 / 0.04, exact);
}

TEST(HullDistance, IsADiscWithAFlatFront) {
  const world::Field field;
  truth::Robot robot;
  EXPECT_NEAR(hull_distance(field, robot, {0.2, 0}), 0.2 - 0.073, exact);
  EXPECT_NEAR(hull_distance(field, robot, {-0.2, 0}), 0.2 - 0.09, exact);
  EXPECT_NEAR(hull_distance(field, robot, {0, 0.2}), 0.2 - 0.09, exact);
  // Continuous where plate, corner and arc meet: around the robot no jump above the step's own length.
  double before = hull_distance(field, robot, {0.12, 0});
  for (int n = 1; n <= 3600; ++n) {
    const double now = hull_distance(field, robot, 0.12 * world::direction(n * 0.001745329));
    EXPECT_LT(std::abs(now - before), 0.12 * 0.0018) << n;
    before = now;
  }
}

}  // namespace
}  // namespace judge

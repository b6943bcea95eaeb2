#include "experiments/judge/witness.h"

#include <gtest/gtest.h>

namespace judge {
namespace {

constexpr world::RobotId blue_1{world::Team::Blue, 1};

world::Time at(double seconds) { return world::Time{world::from_seconds(seconds)}; }

/// The baseline names the robot whenever the ball is within 150 mm of it.
Witness nearest_while(const std::vector<std::pair<double, bool>>& frames) {
  Witness witness = Witness::nearest(world::Geometry{});
  world::GameState state;
  state.location = world::Location::GameOn;
  for (const auto& [time, near] : frames) {
    world::TrackedFrame frame;
    frame.time = at(time);
    frame.ball.emplace();
    frame.ball->position = {near ? 0.1 : 1.0, 0, 0};
    frame.robots.emplace_back();
    frame.robots.back().id = blue_1;
    witness.see(frame, {}, state);
  }
  return witness;
}

TrueTouch touch(double begin, double end, world::RobotId robot = blue_1) {
  TrueTouch one;
  one.robot = robot;
  one.begin = at(begin);
  one.end = at(end);
  one.in_play = true;
  one.kicked = true;
  return one;
}

constexpr auto kick = static_cast<std::size_t>(Kind::Kick);

TEST(Witness, JoinsWhatItNamesWithoutAPause) {
  const Witness witness = nearest_while({{1.0, true}, {1.03, true}, {1.06, true}, {1.2, true}});
  ASSERT_EQ(witness.named().size(), 2u);
  EXPECT_EQ(witness.named()[0].end, at(1.06));
  EXPECT_EQ(witness.last()->robot, blue_1);
}

TEST(Witness, KnowsTheKickerFromTheReferee) {
  Witness witness = Witness::nearest(world::Geometry{});
  world::GameState state;
  state.location = world::Location::GameOn;
  state.location_time = at(2);
  state.kicker = world::RobotId{world::Team::Yellow, 4};
  world::TrackedFrame frame;
  frame.time = at(2.1);
  witness.see(frame, {}, state);
  EXPECT_EQ(witness.last()->robot, state.kicker);
}

TEST(CountTouches, IsByRobotAndWindow) {
  const Witness witness = nearest_while({{1.0, true}, {3.0, true}});
  const std::deque<TrueTouch> truth = {touch(1.2, 1.2), touch(3.05, 3.06),
                                       touch(3.0, 3.0, {world::Team::Yellow, 1})};
  const TouchCount narrow = count_touches(truth, witness, 0.1);
  EXPECT_EQ(narrow.found[kick], 1);
  EXPECT_EQ(narrow.missed[kick], 2);
  EXPECT_EQ(narrow.extra, 1);
  const TouchCount wide = count_touches(truth, witness, 0.3);
  EXPECT_EQ(wide.found[kick], 2);
  EXPECT_EQ(wide.extra, 0);
}

TEST(CountTouches, LetsContactThatLastsStandForAllItOverlaps) {
  std::vector<std::pair<double, bool>> frames;
  for (int n = 0; n < 60; ++n) frames.emplace_back(1 + n / 60.0, true);
  const Witness witness = nearest_while(frames);
  const TouchCount count = count_touches({touch(1.1, 1.2), touch(1.5, 1.6), touch(1.9, 1.9)}, witness, 0.1);
  EXPECT_EQ(count.found[kick], 3);
  EXPECT_EQ(count.own, 1) << "one to one";
  EXPECT_EQ(count.extra + count.again, 0);
}

TEST(CountTouches, TellsASecondNamingFromAFalseOne) {
  const Witness witness = nearest_while({{1.0, true}, {1.1, true}, {5.0, true}});
  const TouchCount count = count_touches({touch(1.0, 1.0)}, witness, 0.3);
  EXPECT_EQ(count.found[kick], 1);
  EXPECT_EQ(count.again, 1);
  EXPECT_EQ(count.extra, 1);
}

}  // namespace
}  // namespace judge

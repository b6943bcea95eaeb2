// A referee's detectors beside the acting one: in its states, a little longer,
// with a last touch of their own.
#include "experiments/judge/shadow.h"

#include <gtest/gtest.h>

namespace judge {
namespace {

using world::Location;

constexpr world::RobotId yellow_1{world::Team::Yellow, 1};
constexpr world::RobotId blue_4{world::Team::Blue, 4};

/// The default referee beside one that signals what is set here; the ball rolls over
/// the touch line when told.
class Shadows : public ::testing::Test {
 protected:
  Shadows() : shadow_("it", world::Geometry{}, world::rule_set("ssl-2015")) {
    state_.location = Location::GameOn;
  }

  void enter(Location location) {
    state_.location = location;
    state_.location_time = now();
  }
  world::Time now() const { return world::tick_time(tick_); }

  /// A frame with the ball at that y; at 3 m is the touch line.
  void frame(double y, std::optional<world::RobotId> touched = {}, bool by_hand = false) {
    world::TrackedFrame frame;
    frame.time = world::tick_time(++tick_);
    frame.ball.emplace();
    frame.ball->position = {0, y, 0};
    frame.ball->velocity = {0, 2, 0};
    frame.ball->observed = true;
    if (touched) frame.touches.push_back({*touched, frame.time, {0, y}, 0.9});
    state_.time = frame.time;
    shadow_.see(frame, state_, by_hand);
  }
  /// From 100 mm inside, 2 m/s; the line is passed in the fourth frame.
  void rolls_out(int frames = 12) {
    for (int n = 0; n < frames; ++n) frame(2.9 + n / 30.0);
  }
  std::vector<Call> exits() const {
    std::vector<Call> found;
    for (const Call& call : shadow_.calls()) {
      if (call.event == Event::Exit) found.push_back(call);
    }
    return found;
  }

  Shadow shadow_;
  world::GameState state_;
  std::int64_t tick_ = 600;
};

TEST_F(Shadows, CallWhatTheySeeInPlay) {
  frame(2, blue_4);
  rolls_out();
  ASSERT_EQ(exits().size(), 1u);
  EXPECT_FALSE(exits()[0].late);
  EXPECT_EQ(exits()[0].last->robot, blue_4);
  EXPECT_GT(exits()[0].reported, exits()[0].time) << "certain a few frames later";
}

TEST_F(Shadows, CallNoExitWhilePlayIsStopped) {
  enter(Location::GameOff);
  rolls_out();
  EXPECT_TRUE(exits().empty());
}

TEST_F(Shadows, GoOnForAMomentInAStateThatWasLeft) {
  frame(2, blue_4);
  rolls_out(6);  // over the line, not yet certain
  EXPECT_TRUE(exits().empty());
  enter(Location::GameOff);
  for (int n = 6; n < 12; ++n) frame(2.9 + n / 30.0);
  ASSERT_EQ(exits().size(), 1u);
  EXPECT_FALSE(exits()[0].late) << "it happened before the whistle";
}

TEST_F(Shadows, SayWhatHappenedAfterTheWhistleIsLate) {
  frame(2, blue_4);
  enter(Location::GameOff);
  rolls_out();  // 0.2 s
  ASSERT_EQ(exits().size(), 1u);
  EXPECT_TRUE(exits()[0].late);
}

TEST_F(Shadows, StopAfterFourTenthsOfASecond) {
  for (const int ticks : {20, 26}) {  // the third frame outside is 0.1 s later: at 0.43 s, and at 0.53 s
    Shadow fresh("it", world::Geometry{}, world::rule_set("ssl-2015"));
    shadow_ = std::move(fresh);
    enter(Location::GameOn);
    frame(2, blue_4);
    enter(Location::GameOff);
    for (int n = 0; n < ticks - 6; ++n) frame(2.5);
    rolls_out();
    EXPECT_EQ(exits().size(), ticks == 20 ? 1u : 0u) << ticks;
  }
}

TEST_F(Shadows, StopAtOnceWhenTheBallIsPutSomewhere) {
  frame(2, blue_4);
  enter(Location::GameOff);
  frame(2.8, {}, true);
  rolls_out();
  EXPECT_TRUE(exits().empty());
}

TEST_F(Shadows, BeginAnewWithEachPassageOfPlay) {
  frame(2, blue_4);
  rolls_out();
  enter(Location::GameOff);
  frame(2);
  enter(Location::GameOn);
  state_.kicker = yellow_1;
  frame(2);
  rolls_out();
  ASSERT_EQ(exits().size(), 2u);
  EXPECT_EQ(exits()[1].last->robot, yellow_1) << "the referee says who took the kick";
}

TEST_F(Shadows, TakeTheLastTouchOfTheActingRefereeOnlyWhenTheyJoin) {
  state_.last_touch.emplace();
  state_.last_touch->robot = yellow_1;
  frame(2);
  frame(2.1, blue_4);
  state_.last_touch->robot = {world::Team::Yellow, 5};  // it thinks otherwise
  rolls_out();
  ASSERT_EQ(exits().size(), 1u);
  EXPECT_EQ(exits()[0].last->robot, blue_4);

  Shadow late("late", world::Geometry{}, world::rule_set("ssl-2015"));
  shadow_ = std::move(late);
  enter(Location::GameOn);
  state_.last_touch->robot = yellow_1;
  rolls_out();
  ASSERT_EQ(exits().size(), 1u);
  EXPECT_EQ(exits()[0].last->robot, yellow_1);
}

}  // namespace
}  // namespace judge

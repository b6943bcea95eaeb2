// Goals and chipped goals: instants, posts, and flights that the filter takes back.
#include "autoref/detectors/goal.h"

#include <gtest/gtest.h>

#include "autoref/detectors/chipped_goal.h"
#include "tests/autoref/detectors/ways.h"

namespace detectors {
namespace {

using world::GameEvent;
using world::Team;
using world::Time;
using world::TrackedFrame;
using world::Vector2d;

TEST(Goal, ReportsWhenAndWhereTheLineWasCrossed) {
  Goal detector(rules());
  std::vector<GameEvent> events = along(detector, {4.4, 0.1}, {2, 0}, 10);
  EXPECT_TRUE(events.empty());
  events = along(detector, {4.6, 0.1}, {0, 0}, 10, false, Time{110ms});
  ASSERT_EQ(events.size(), 1u);
  EXPECT_NEAR(seconds_of(events[0]), 0.1215 / 2, one_rounding);
  EXPECT_EQ(std::get<world::PossibleGoal>(events[0].what).defending, Team::Blue);
}

// The filter runs past the post for a frame before it believes that the ball bounced off it into the goal.
TEST(Goal, MayComeOffThePost) {
  for (const bool into_the_goal : {true, false}) {
    Goal detector(rules());
    std::vector<GameEvent> all;
    for (int i = 0; i < 30; ++i) {
      const Vector2d ball = i < 3   ? Vector2d{4.41 + 0.05 * i, 0.47}
                            : i < 4 ? Vector2d{4.56, 0.53}
                                    : Vector2d{4.6, into_the_goal ? 0.45 : 0.55};
      for (GameEvent& event : detector.update(frame_at(Time{i * 16ms}, ball), world::GameState{})) {
        all.push_back(event);
      }
    }
    EXPECT_EQ(all.size(), into_the_goal ? 1u : 0u);
  }
}

TEST(Goal, IsNoneBesideThePost) {
  Goal detector(rules());
  along(detector, {4.4, 0.51}, {2, 0}, 10);
  EXPECT_TRUE(along(detector, {4.6, 0.51}, {0, 0}, 60, false, Time{1s}).empty());
}

// It bounced along the line when it came off the post, and the filter thought that it passed beside the goal.
TEST(Goal, IsOneWhenTheBallIsInsideThoughItSeemedToPassThePost) {
  Goal detector(rules());
  std::vector<GameEvent> all = along(detector, {4.41, 0.47}, {5, 2}, 2);  // to 4.51, 0.51
  for (const GameEvent& event : along(detector, {4.53, 0.45}, {1, -1}, 20, false, Time{30ms})) {
    all.push_back(event);
  }
  ASSERT_EQ(all.size(), 1u);
  EXPECT_NEAR(seconds_of(all[0]), 0.025, 0.006);  // within the frames around the line
}

TEST(Goal, IsTheSameWhenTheBallComesOutAndGoesInAgain) {
  for (const Time again : {Time{400ms}, Time{900ms}}) {
    Goal detector(rules());
    std::size_t goals = along(detector, {4.4, 0.1}, {2, 0}, 20).size();
    goals += along(detector, {4.5, 0.1}, {0, 0}, 2, false, Time{210ms}).size();
    goals += along(detector, {4.5, 0.1}, {2, 0}, 12, false, again).size();
    EXPECT_EQ(goals, again < Time{500ms} ? 1u : 2u);
  }
}

struct Flight {
  double last_height = 0;  // [m] of a ball at 0.4 m, before it is on the ground
  bool chipped = false;
};

class FlightsTakenBack : public testing::TestWithParam<Flight> {};

// A ball comes down from 0.4 m before it is on the ground. One that is there at once never flew: the filter
// has thought again.
TEST_P(FlightsTakenBack, AreNoChips) {
  ChippedGoal detector(rules());
  world::GameState state;
  state.last_touch = world::Touch{.robot = yellow_3, .time = Time{0ms}, .position = {3.9, 0.1}};
  std::vector<GameEvent> all;
  for (int i = 0; i < 60; ++i) {
    TrackedFrame frame = frame_at(Time{i * 10ms}, {3.9 + 0.03 * std::min(i, 25), 0.1});
    frame.robots.clear();
    const double height = i < 10 ? 0.4 : 0.4 - 0.06 * (i - 9);
    if (height > GetParam().last_height - 1e-9) {
      frame.ball->position.z() = height;
      frame.ball->airborne = 0.99;
      frame.ball->flight = world::Flight{.kicked = Time{0ms}, .from = {3.9, 0.1}, .highest = 0.4};
    }
    for (GameEvent& event : detector.update(frame, state)) all.push_back(event);
  }
  EXPECT_EQ(all.size(), GetParam().chipped ? 1u : 0u);
}

INSTANTIATE_TEST_SUITE_P(Heights, FlightsTakenBack, testing::Values(Flight{0.04, true}, Flight{0.22, false}));

}  // namespace
}  // namespace detectors

#include "autoref/detectors/ball_left_field.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "autoref/detectors/ball.h"
#include "tests/autoref/detectors/ways.h"

namespace detectors {
namespace {

using namespace std::chrono_literals;
using world::GameEvent;
using world::Time;
using world::TrackedFrame;
using world::Vector2d;

TEST(BallLeftField, FiresWithTheThirdFrameOutsideAndKnowsWhereAndWhen) {
  BallLeftField detector(rules());
  EXPECT_TRUE(along(detector, {1.0, 2.9}, {1, 2}, 8).empty());  // outside from frame 7 on: two frames
  detector.reset();
  const auto events = along(detector, {1.0, 2.9}, {1, 2}, 30);
  ASSERT_EQ(events.size(), 1u);
  const auto& left = std::get<world::BallLeftFieldTouchLine>(events[0].what);
  EXPECT_NEAR(seconds_of(events[0]), 0.1215 / 2, one_rounding);
  EXPECT_NEAR(left.location.x(), 1.0 + 0.1215 / 2, 1e-12);
  EXPECT_NEAR(left.location.y(), 3.0215, 1e-12);
}

TEST(BallLeftField, CountsOnlyFramesInWhichTheBallWasSeenOrARobotHidIt) {
  BallLeftField detector(rules());
  along(detector, {0, 3.0}, {0, 1}, 3);  // one frame outside
  for (int i = 0; i < 10; ++i) {
    TrackedFrame unseen = frame_at(Time{1s + i * 10ms}, {0, 3.2});
    unseen.ball->observed = false;
    unseen.robots.clear();
    EXPECT_TRUE(detector.update(unseen, world::GameState{}).empty());
  }
}

// A robot that hides the ball may carry it out for seconds; Algorithm 2 would wait until it is seen.
TEST(BallLeftField, ARobotCarriesAHiddenBallOut) {
  struct Case {
    const char* rules;
    int last_seen;
    bool called;
  };
  for (const Case& c : {Case{"ssl-2015", 20, true}, Case{"ssl-2015", -90, true}, Case{"paper", 20, false}}) {
    BallLeftField detector(world::rule_set(c.rules));
    along(detector, {0, 2.7}, {0, 0}, 0, false, Time{-1s});
    std::optional<int> reported;
    for (int i = 0; i <= 100; ++i) {
      TrackedFrame frame = frame_at(Time{i * 10ms}, {0, 2.8 + 0.005 * i});
      frame.ball->observed = i <= c.last_seen;
      frame.ball->unseen = std::max(0, i - c.last_seen) * 10ms;
      frame.ball->outside = i > 50 ? 0.98 : 0.96;  // from then on it is believed 30 mm outside
      for (const GameEvent& event : detector.update(frame, world::GameState{})) {
        reported = i;
        EXPECT_NEAR(seconds_of(event), 0.443, 1e-3);  // when it was believed to cross 3.0215 m
      }
    }
    // Surely outside from frame 51 on, the twelfth of them.
    EXPECT_EQ(reported, c.called ? std::optional(62) : std::nullopt);
  }
}

// A robot holds it 25 mm from the line for a second, unseen or believed elsewhere,
// then kicks it out at 2 m/s.
TEST(BallLeftField, AnExitThatNobodySawIsDatedBackAlongTheWayOutside) {
  for (const bool believed_elsewhere : {false, true}) {
    BallLeftField detector(rules());
    std::vector<GameEvent> events;
    for (int i = 0; i <= 110; ++i) {
      const double way = std::max(0, i - 100) * 0.02;
      TrackedFrame frame = frame_at(Time{i * 10ms}, {0, 2.9965 + way});
      if (i > 10 && i < 104) {
        frame.ball->observed = false;
        frame.ball->position.y() = 2.7;
        frame.robots[0].position = Vector2d(0, 2.6);
        if (!believed_elsewhere) frame.ball.reset();
      }
      for (GameEvent& event : detector.update(frame, world::GameState{})) events.push_back(event);
    }
    ASSERT_EQ(events.size(), 1u);
    EXPECT_NEAR(seconds_of(events[0]), 1.0125, one_rounding);  // 25 mm at 2 m/s
  }
}

// Kicked 20 mm before the line, a chip is shown beyond it at once; a ball that rolls out
// is out, kicked or not.
TEST(BallLeftField, WaitsWhileAKickedBallMayFly) {
  for (const bool rolled_out : {false, true}) {
    BallLeftField detector(rules());
    std::optional<int> reported;
    for (int i = 0; i <= 60; ++i) {
      const int kicked = rolled_out ? 12 : 8;  // outside from frame 11 on, at 2 m/s
      TrackedFrame frame = frame_at(Time{i * 10ms}, {0, 3.0215 + 0.02 * (i - 10.5)});
      frame.ball->may_fly = i >= kicked;
      if (!detector.update(frame, world::GameState{}).empty()) reported = i;
    }
    EXPECT_EQ(reported, rolled_out ? 13 : 36);  // the third frame outside; 250 ms after the first
  }
}

TEST(BallLeftField, TellsAnExitAgainOnlyWhenTheBallWasClearlyInside) {
  struct Case {
    double inside;  // [m]
    int frames;
    std::size_t told;
  };
  for (const Case& c : {Case{0.015, 20, 1}, Case{0.025, 2, 1}, Case{0.025, 3, 2}}) {
    BallLeftField detector(rules());
    along(detector, {0, 2.8}, {0, 0}, 5);
    std::size_t told = along(detector, {0, 3.03}, {0, 0}, 5, false, Time{100ms}).size();
    told += along(detector, {0, 3.0215 - c.inside}, {0, 0}, c.frames - 1, false, Time{200ms}).size();
    told += along(detector, {0, 3.03}, {0, 0}, 5, false, Time{500ms}).size();
    EXPECT_EQ(told, c.told) << c.inside << " " << c.frames;
  }
}

TEST(BallLeftField, BeginsOutsideWithoutAnEntry) {
  BallLeftField detector(rules());
  const auto events = along(detector, {4.9, 1.0}, {0, 0}, 5);
  ASSERT_EQ(events.size(), 1u);
  EXPECT_NEAR(std::get<world::BallLeftFieldGoalLine>(events[0].what).location.x(), 4.5215, 1e-12);
}

TEST(BallLeftField, KnowsTheFirstLineThatWasCrossedInACorner) {
  const Crossing first = crossing(rules().field, {4.4, 2.9}, {4.6, 3.2});
  EXPECT_FALSE(first.goal_line);  // the touch line after 0.405 of the way, the goal line after 0.608
  EXPECT_TRUE(crossing(rules().field, {4.4, 2.9}, {4.7, 3.05}).goal_line);
}

}  // namespace
}  // namespace detectors

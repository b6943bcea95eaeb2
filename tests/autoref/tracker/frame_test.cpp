#include <gtest/gtest.h>

#include <functional>

#include "tests/autoref/tracker/running.h"

namespace tracker {
namespace {

TEST(Tracker, FrameTimeIsTheNewestCaptureAndRobotsAreSorted) {
  Tracker tracker{world::Geometry{}};
  Cameras cameras;
  const Motion motion = standing(
      Vector2d(0, 0),
      {{{Team::Blue, 1}, {1, 1}, 0}, {{Team::Yellow, 9}, {-1, 1}, 0}, {{Team::Yellow, 2}, {-1, -1}, 0}});
  run(tracker, cameras, 1, 5, motion, [](std::int64_t tick, const world::TrackedFrame& frame) {
    EXPECT_EQ(frame.time, world::whole_microseconds(world::tick_time(tick)));
  });
  ASSERT_EQ(tracker.frame().robots.size(), 3u);
  EXPECT_TRUE(std::ranges::is_sorted(tracker.frame().robots, {}, &world::TrackedRobot::id));
  EXPECT_TRUE(tracker.frame().ball->observed);
  EXPECT_EQ(tracker.frame().ball->unseen, world::Duration{});
}

TEST(Tracker, NothingNewerMeansNoFrame) {
  Tracker tracker{world::Geometry{}};
  Cameras cameras;
  EXPECT_EQ(tracker.update({}), nullptr);
  const auto images = cameras.images(1, standing(Vector2d(0, 0)));
  EXPECT_NE(tracker.update(images), nullptr);
  EXPECT_EQ(tracker.update(images), nullptr);  // a repeat
  EXPECT_EQ(tracker.update({}), nullptr);
  EXPECT_NE(tracker.update(cameras.images(2, standing(std::nullopt))), nullptr);  // empty images are news
}

TEST(Tracker, OrderOfCamerasInABatchDoesNotMatter) {
  Tracker forward{world::Geometry{}};
  Tracker backward{world::Geometry{}};
  Cameras cameras;
  const Game game(1, 2);
  for (std::int64_t tick = 1; tick <= 60; ++tick) {
    auto images = cameras.images(tick, std::cref(game));
    forward.update(images);
    std::ranges::reverse(images);
    backward.update(images);
  }
  ASSERT_EQ(forward.frame().robots.size(), 12u);
  for (std::size_t n = 0; n < 12; ++n) {
    EXPECT_EQ(forward.frame().robots[n].position, backward.frame().robots[n].position);
  }
  EXPECT_EQ(forward.frame().ball->velocity, backward.frame().ball->velocity);
}

}  // namespace
}  // namespace tracker

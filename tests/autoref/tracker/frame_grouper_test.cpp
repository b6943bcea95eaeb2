#include "autoref/tracker/frame_grouper.h"

#include <gtest/gtest.h>

#include "autoref/tracker/tracker.h"
#include "tests/autoref/tracker/synthetic.h"

namespace tracker {
namespace {

std::vector<int> cameras_of(std::span<const world::Detection> batch) {
  std::vector<int> ids;
  for (const world::Detection& image : batch) ids.push_back(image.camera);
  return ids;
}

world::Detection image(int camera) {
  world::Detection detection;
  detection.camera = camera;
  return detection;
}

TEST(FrameGrouper, GivesTheHostsBatches) {
  synthetic::Cameras cameras;
  FrameGrouper grouper;
  std::vector<world::Detection> before;
  for (std::int64_t tick = 1; tick <= 20; ++tick) {
    const auto images = cameras.images(tick, [](double t) { return synthetic::Scene{Vector2d(t, 0), {}}; });
    for (std::size_t n = 0; n < images.size(); ++n) {
      const auto batch = grouper.add(images[n]);
      if (n > 0 || tick == 1) {
        EXPECT_TRUE(batch.empty());
        continue;
      }
      ASSERT_EQ(batch.size(), before.size());  // the first camera's next image completes the last tick
      for (std::size_t k = 0; k < batch.size(); ++k) {
        EXPECT_EQ(batch[k].camera, before[k].camera);
        EXPECT_EQ(batch[k].t_capture, before[k].t_capture);
        EXPECT_EQ(batch[k].balls.size(), before[k].balls.size());
      }
    }
    before = images;
  }
  EXPECT_EQ(cameras_of(grouper.flush()), (std::vector{0, 1, 2, 3}));
  EXPECT_TRUE(grouper.flush().empty());
}

TEST(FrameGrouper, SilentCameraMakesSmallerBatches) {
  FrameGrouper grouper;
  EXPECT_TRUE(grouper.add(image(0)).empty());
  EXPECT_TRUE(grouper.add(image(2)).empty());
  EXPECT_EQ(cameras_of(grouper.add(image(0))), (std::vector{0, 2}));
  EXPECT_EQ(cameras_of(grouper.add(image(0))), (std::vector{0}));
  EXPECT_EQ(cameras_of(grouper.flush()), (std::vector{0}));
}

TEST(FrameGrouper, EndlessNewCamerasDoNotFillTheMemory) {
  FrameGrouper grouper;
  std::size_t longest = 0;
  for (int camera = 0; camera < 1000; ++camera)
    longest = std::max(longest, grouper.add(image(camera)).size());
  EXPECT_EQ(longest, 64u);
}

}  // namespace
}  // namespace tracker

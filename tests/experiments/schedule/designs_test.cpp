// The designs that come with the program.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "experiments/schedule/design.h"

namespace schedule {
namespace {

TEST(Designs, AreAllValidAndNamedLikeTheirFiles) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(SOURCE_DIR "/experiments/designs")) {
    if (entry.path().extension() != ".toml") continue;
    ++count;
    EXPECT_EQ(read_design(entry.path()).name, entry.path().stem().string());
  }
  EXPECT_GE(count, 5);
}

}  // namespace
}  // namespace schedule

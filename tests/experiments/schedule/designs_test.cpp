// The designs that come with the program, and names that the design reader knows by heart.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "experiments/schedule/design.h"
#include "sim/engine/realism.h"

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

TEST(Designs, MayNameEveryRealismPresetOfTheEngine) {
  for (const engine::Realism& realism : engine::realism_presets()) {
    const std::string text = "name = \"n\"\npairs = 1\nrealism = \"" + realism.name +
                             "\"\n[teams]\na.command = \"x\"\nb.command = \"x\"\n";
    EXPECT_EQ(parse_design(text, "n.toml").realism.preset, realism.name);
  }
}

}  // namespace
}  // namespace schedule

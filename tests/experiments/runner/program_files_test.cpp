#include "experiments/runner/program_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "tests/experiments/runner/support.h"

namespace runner {
namespace {

TEST(HashOf, IsXxh3) {
  // The value the xxHash project gives for the empty input with seed 0.
  EXPECT_EQ(hash_of(""), "99aa06d3014798d86001c324468d497f");
}

TEST(ProgramFiles, AreProgramsAndFilesInArguments) {
  const TemporaryFolder folder;
  const std::string script = (folder.path() / "team.py").string();
  std::ofstream(script) << "print(1)\n";
  schedule::Design design = small_design(1);
  design.conditions[1].b.command = {"true", "--flag", script, "no-such-file"};
  const std::vector<ProgramFile> files = program_files(design);
  ASSERT_EQ(files.size(), 2U);
  EXPECT_TRUE(files[0].path == script || files[1].path == script);
}

TEST(ProgramFiles, NamesConditionTeamAndProgramThatIsMissing) {
  schedule::Design design = small_design(1);
  design.conditions[1].b.command = {"no-such-team"};
  try {
    program_files(design);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("condition 'slow', team b: program 'no-such-team'"));
  }
}

TEST(ExperimentHash, ChangesWithDesignFilesAndProtocol) {
  const schedule::Design design = small_design(1);
  const std::vector<ProgramFile> files = {{"/a", "1"}, {"/b", "2"}};
  const std::string hash = experiment_hash(design, files, "1");
  EXPECT_EQ(hash.size(), 32U);
  EXPECT_EQ(hash, experiment_hash(design, {{"/elsewhere", "2"}, {"/a", "1"}}, "1")) << "paths do not count";
  EXPECT_NE(hash, experiment_hash(design, {{"/a", "1"}, {"/b", "3"}}, "1"));
  EXPECT_NE(hash, experiment_hash(design, files, "2"));
  EXPECT_NE(hash, experiment_hash(small_design(2), files, "1"));
}

}  // namespace
}  // namespace runner

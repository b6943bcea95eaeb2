#include "experiments/process/program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

namespace process {
namespace {

std::string reason(const std::string& name) {
  try {
    find_program(name);
  } catch (const StartError& error) {
    return error.what();
  }
  return "found";
}

TEST(FindProgram, FindsABareNameBesideTheRunningProgramAndThenInThePath) {
  const std::filesystem::path own = std::filesystem::read_symlink("/proc/self/exe");
  EXPECT_EQ(find_program(own.filename().string()), own);
  EXPECT_EQ(find_program("sh").filename(), "sh");
}

TEST(FindProgram, TakesANameWithASlashAsAPath) { EXPECT_EQ(find_program("/bin/sh"), "/bin/sh"); }

TEST(FindProgram, SaysWhatItLookedFor) {
  EXPECT_THAT(reason("no-such-team"), testing::HasSubstr("'no-such-team' found neither in"));
  EXPECT_EQ(reason("/nowhere/team"), "program '/nowhere/team' does not exist");
  EXPECT_EQ(
      reason(SOURCE_DIR "/CMakeLists.txt"),
      "program '" SOURCE_DIR
      "/CMakeLists.txt' is not an executable file; make it one with chmod +x, or begin the command with "
      "its interpreter, as python3");
  EXPECT_EQ(reason(""), "the command of a program is empty");
}

}  // namespace
}  // namespace process

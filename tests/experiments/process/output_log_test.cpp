#include "experiments/process/output_log.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

namespace process {
namespace {

std::string read(const std::filesystem::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(OutputLog, KeepsTheFirstBytesAndSaysThatTheRestIsMissing) {
  const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / "output_log_test.log";
  {
    OutputLog log(path, 10);
    log.write("12345");
    log.write("67890abc");
    log.write("def");
    EXPECT_EQ(log.written(), 10U);
    EXPECT_EQ(log.discarded(), 6U);
  }
  EXPECT_EQ(read(path), "1234567890\n[output limit of 10 bytes reached; the rest is discarded]\n");
  std::filesystem::remove(path);
}

// What a sentence about a failed team quotes; known without a file.
TEST(OutputLog, KnowsTheLastLine) {
  OutputLog log({}, 0);
  EXPECT_EQ(log.last_line(), "");
  log.write("one\nunknown argu");
  log.write("ment \x1b[0m--x\n \n");
  EXPECT_EQ(log.last_line(), "unknown argument  [0m--x");
  const std::string flood(5000, 'a');
  log.write(flood);
  log.write("b");
  EXPECT_EQ(log.last_line(), "..." + flood.substr(0, 199) + "b");
}

TEST(OutputLog, SaysWhichFileItCannotMake) {
  EXPECT_THAT(
      [] { OutputLog log("/nowhere/x.log", 10); },
      testing::ThrowsMessage<std::runtime_error>("cannot write /nowhere/x.log: No such file or directory"));
}

}  // namespace
}  // namespace process

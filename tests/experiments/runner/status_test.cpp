#include "experiments/runner/status.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/experiments/runner/support.h"

namespace runner {
namespace {

TEST(Status, IsJsonThatReadsBack) {
  Status status;
  status.state = "running";
  status.reason = "a \"quoted\" reason\n";
  status.games = 100;
  status.resolved = 40;
  status.left = TimeLeft::Estimate{60, 50, 70};
  status.running.push_back({"equal-0003-1", 2, "game", 12.5, 0.25});
  const auto json = nlohmann::json::parse(to_json(status));
  EXPECT_EQ(json.at("state"), "running");
  EXPECT_EQ(json.at("reason"), "a \"quoted\" reason\n");
  EXPECT_EQ(json.at("games"), 100);
  EXPECT_EQ(json.at("left").at("high"), 70);
  EXPECT_EQ(json.at("running").at(0).at("simulated"), 12.5);
  status.left.reset();
  EXPECT_TRUE(nlohmann::json::parse(to_json(status)).at("left").is_null());
}

TEST(Status, ReplacesTheFileAsAWholeAndForgivesADiskThatWillNot) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "status.json";
  write_status(file, {});
  write_status(file, {});
  std::ifstream stream(file);
  EXPECT_NO_THROW(nlohmann::json::parse(stream));
  EXPECT_NO_THROW(write_status("/proc/nowhere/status.json", {}));
}

TEST(Status, CountsOpenFiles) {
  const std::size_t before = open_files();
  const int file = ::open("/dev/null", O_RDONLY);
  EXPECT_EQ(open_files(), before + 1);
  ::close(file);
}

}  // namespace
}  // namespace runner

#include "experiments/process/whole_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/resource.h>

#include <csignal>
#include <fstream>
#include <iterator>
#include <system_error>
#include <vector>

namespace process {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class WholeFile : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "whole-file-test-XXXXXX").string();
    ASSERT_NE(::mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  void TearDown() override { fs::remove_all(folder_); }
  std::string read(const char* name) const {
    std::ifstream stream(folder_ / name);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  std::size_t files() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }
  std::string complaint(const fs::path& file, const std::string& text) const {
    try {
      write_whole(file, text);
    } catch (const std::system_error& error) {
      return error.what();
    }
    return "written";
  }
  fs::path folder_;
};

TEST_F(WholeFile, ReplacesWhatWasThere) {
  write_whole(folder_ / "file", "one");
  write_whole(folder_ / "file", "two");
  EXPECT_EQ(read("file"), "two");
  EXPECT_EQ(files(), 1U);
}

TEST_F(WholeFile, NamesFileAndCauseAndLeavesWhatWasThere) {
  write_whole(folder_ / "file", "before");
  const auto usual = std::signal(SIGXFSZ, SIG_IGN);  // then a file above the limit is an error
  rlimit before{};
  ::getrlimit(RLIMIT_FSIZE, &before);
  const rlimit small{1000, before.rlim_max};
  ::setrlimit(RLIMIT_FSIZE, &small);
  const std::string said = complaint(folder_ / "file", std::string(2000, 'x'));
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, usual);
  EXPECT_EQ(said, (folder_ / "file").string() + ": cannot be written: File too large");
  EXPECT_EQ(read("file"), "before");
  EXPECT_EQ(files(), 1U);
}

TEST_F(WholeFile, SaysThatTheFolderIsMissing) {
  EXPECT_THAT(complaint(folder_ / "no" / "file", "x"), HasSubstr("file: cannot be written: No such file"));
}

}  // namespace
}  // namespace process

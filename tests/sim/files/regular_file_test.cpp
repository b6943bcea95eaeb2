#include "sim/files/regular_file.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <unistd.h>

#include <fstream>

#include "tests/fakes/odd_files.h"

namespace {

namespace fs = std::filesystem;

class Files : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "files-test-XXXXXX").string();
    ASSERT_NE(::mkdtemp(name.data()), nullptr);
    folder_ = name;
    ::alarm(20);  // [s] a file that blocks ends the test
  }
  void TearDown() override {
    ::alarm(0);
    fs::remove_all(folder_);
  }
  static std::string complaint(const fs::path& file, std::size_t most = 1 << 20) {
    try {
      files::text_of(file, most);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  }
  fs::path folder_;
};

TEST_F(Files, AreReadWhole) {
  for (const std::size_t size : {0U, 1U, 65'535U, 65'536U, 65'537U, 1U << 20}) {
    const std::string text(size, 'x');
    std::ofstream(folder_ / "file", std::ios::trunc) << text;
    EXPECT_EQ(files::text_of(folder_ / "file", 1 << 20), text) << size;
  }
}

TEST_F(Files, AreRefusedWhenTheyAreLonger) {
  std::ofstream(folder_ / "file") << std::string((1 << 20) + 1, 'x');
  EXPECT_EQ(complaint(folder_ / "file"), (folder_ / "file").string() + ": has more than 1 MiB");
}

TEST_F(Files, ThatAreNoneAreRefusedAtOnceAndNamed) {
  for (const fakes::OddFile& odd : fakes::odd_files()) {
    odd.make(folder_ / "odd");
    EXPECT_EQ(files::not_regular(folder_ / "odd"), odd.sentence);
    EXPECT_EQ(complaint(folder_ / "odd"), (folder_ / "odd").string() + ": " + odd.sentence);
    fs::create_symlink("odd", folder_ / "link");
    EXPECT_EQ(complaint(folder_ / "link"), (folder_ / "link").string() + ": " + odd.sentence);
    fs::remove(folder_ / "link");
  }
}

TEST_F(Files, OfADescriptorThatIsAPipeAreRefused) {
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  EXPECT_THAT(complaint("/dev/fd/" + std::to_string(ends[0])), testing::HasSubstr("is a named pipe (FIFO)"));
  ::close(ends[0]);
  ::close(ends[1]);
}

TEST_F(Files, ThatAreNotThereSayWhy) {
  EXPECT_EQ(files::not_regular(folder_ / "none"), "");
  EXPECT_EQ(complaint(folder_ / "none"),
            (folder_ / "none").string() + ": cannot be read: No such file or directory");
}

}  // namespace

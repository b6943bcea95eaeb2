#include "experiments/process/tree.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>
#include <string>

namespace process {
namespace {

namespace fs = std::filesystem;

class Tree : public testing::Test {
 protected:
  Tree() { fs::create_directories(folder_); }
  ~Tree() override { remove_tree(outer_); }

  void write(const fs::path& name, std::size_t bytes) const {
    std::ofstream(folder_ / name) << std::string(bytes, 'x');
  }
  /// Folders in folders, far deeper than a path can be long (4096 bytes) or files may be open.
  void make_deep(int depth) const {
    int at = ::open(folder_.c_str(), O_RDONLY | O_DIRECTORY);
    for (int i = 0; i < depth; ++i) {
      ASSERT_EQ(::mkdirat(at, "a-folder-with-a-name", 0700), 0);
      const int next = ::openat(at, "a-folder-with-a-name", O_RDONLY | O_DIRECTORY);
      ::close(at);
      at = next;
    }
    ::close(at);
  }

  fs::path outer_ = fs::temp_directory_path() / ("tree-" + std::to_string(::getpid()));
  fs::path folder_ = outer_ / "logs";
};

TEST_F(Tree, CountsFilesAndFolders) {
  write("one", 100'000);
  fs::create_directory(folder_ / "below");
  write("below/two", 50'000);
  const TreeSize size = tree_size(folder_);
  EXPECT_GE(size.bytes, 150'000);
  EXPECT_LE(size.bytes, 150'000 + 2 * 65'536) << "whole blocks, of a disk with large ones";
  EXPECT_EQ(size.entries, 3U);
  EXPECT_TRUE(size.whole);
}

TEST_F(Tree, CountsWhatFilesTakeAndNotWhatTheySay) {
  write("holes", 1);
  fs::resize_file(folder_ / "holes", std::uintmax_t{1} << 40);
  EXPECT_LT(tree_size(folder_).bytes, 100'000);
  write("set-aside", 1);
  const int file = ::open((folder_ / "set-aside").c_str(), O_WRONLY);
  const int failed = ::fallocate(file, FALLOC_FL_KEEP_SIZE, 0, 1 << 20);
  ::close(file);
  if (failed != 0) GTEST_SKIP() << "the disk sets nothing aside";
  EXPECT_GE(tree_size(folder_).bytes, 1 << 20);
}

TEST_F(Tree, FollowsNoLinkAndOpensNoPipe) {
  const fs::path outside = outer_ / "outside";
  fs::create_directory(outside);
  std::ofstream(outside / "big") << std::string(1'000'000, 'x');
  fs::create_symlink(outside / "big", folder_ / "file");
  fs::create_directory_symlink(outside, folder_ / "folder");
  fs::create_directory_symlink(folder_, folder_ / "circle");
  ASSERT_EQ(::mkfifo((folder_ / "pipe").c_str(), 0600), 0);
  EXPECT_LT(tree_size(folder_).bytes, 100'000);
  EXPECT_EQ(tree_size(folder_).entries, 4U);
  remove_tree(folder_);
  EXPECT_FALSE(fs::exists(fs::symlink_status(folder_)));
  EXPECT_TRUE(fs::exists(outside / "big"));
}

TEST_F(Tree, AFileWithHolesCountsWhatItFills) {
  write("holes", 1);
  fs::resize_file(folder_ / "holes", std::uintmax_t{1} << 40);  // a terabyte
  EXPECT_LT(tree_size(folder_).bytes, 1'000'000);
}

TEST_F(Tree, IsNotExhaustedByDepth) {
  make_deep(3000);
  EXPECT_FALSE(tree_size(folder_).whole);
  remove_tree(folder_);
  EXPECT_FALSE(fs::exists(folder_));
}

TEST_F(Tree, IsNotExhaustedByNumber) {
  for (int i = 0; i < 200; ++i) write(std::to_string(i), 1);
  EXPECT_FALSE(tree_size(folder_, {.entries = 100, .depth = 3}).whole);
  EXPECT_EQ(tree_size(folder_, {.entries = 100, .depth = 3}).entries, 101U);
  remove_tree(folder_);
  EXPECT_FALSE(fs::exists(folder_));
}

TEST_F(Tree, RemovesFoldersWithoutRights) {
  fs::create_directories(folder_ / "a" / "b" / "c");
  write("a/b/c/file", 10);
  for (const char* name : {"a/b/c", "a/b", "a"}) ::chmod((folder_ / name).c_str(), 0);
  // Root may do everything; as somebody else this needs the rights back.
  remove_tree(folder_);
  EXPECT_FALSE(fs::exists(folder_));
}

TEST_F(Tree, RemovesAFileAndALinkAndNothingAtAll) {
  write("file", 3);
  fs::create_symlink(outer_, folder_ / "link");
  remove_tree(folder_ / "file");
  remove_tree(folder_ / "link");
  remove_tree(folder_ / "nothing");
  EXPECT_TRUE(fs::is_empty(folder_));
}

}  // namespace
}  // namespace process

#include "experiments/builds/git.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/experiments/builds/repository.h"

namespace builds {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

std::string complaint(const std::string& repository, const std::string& revision) {
  try {
    commit_of(repository, revision, "team a");
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Git, FindsBranchTagAndCommit) {
  const Repository repository;
  const std::string path = repository.path();
  const std::string main = commit_of(path, "main", "a");
  EXPECT_EQ(main.size(), 40U);
  EXPECT_EQ(commit_of(path, "v1", "a"), main);
  EXPECT_EQ(commit_of(path, main.substr(0, 10), "a"), main);
  EXPECT_NE(commit_of(path, "feature", "a"), main);
}

TEST(Git, FindsABranchThatOnlyTheOriginHas) {
  const Repository repository;
  const fs::path clone = repository.folder() / "clone";
  repository.shell("git clone -q . '" + clone.string() + "'");
  EXPECT_EQ(commit_of(clone, "feature", "a"), commit_of(repository.path(), "feature", "a"));
}

TEST(Git, NamesTeamRepositoryAndRevisionThatAreWrong) {
  const Repository repository;
  EXPECT_THAT(complaint(repository.path(), "featur"),
              HasSubstr("team a: repository '" + repository.path().string() +
                        "': has no revision 'featur'; did you mean feature?"));
  EXPECT_THAT(complaint(repository.folder(), "main"), HasSubstr("is no git repository; git says: "));
  EXPECT_THAT(complaint("/nowhere", "main"), HasSubstr("repository '/nowhere': is no git repository"));
  EXPECT_THAT(complaint(repository.path(), "--all"), HasSubstr("has no revision '--all'"))
      << "not taken for a flag";
}

TEST(Git, RefusesANameThatIsABranchAndATagOfDifferentCommits) {
  const Repository repository;
  const std::string path = repository.path();
  const std::string main = commit_of(path, "main", "a");
  const std::string feature = commit_of(path, "feature", "a");
  repository.shell("git tag same main && git branch same main");
  EXPECT_EQ(commit_of(path, "same", "a"), main) << "no harm";
  repository.shell("git tag main feature");
  EXPECT_THAT(complaint(path, "main"),
              HasSubstr("team a: repository '" + path +
                        "': the revision 'main' is ambiguous: refs/heads/main is commit " +
                        main.substr(0, 12) + ", refs/tags/main is commit " + feature.substr(0, 12) +
                        "; write the one that is meant with its full name, as refs/heads/main"));
  EXPECT_THAT(complaint(path, "main~0"), HasSubstr("is ambiguous"));
  EXPECT_EQ(commit_of(path, "refs/heads/main", "a"), main);
  EXPECT_EQ(commit_of(path, "heads/main", "a"), main);
  EXPECT_EQ(commit_of(path, "refs/tags/main", "a"), feature);
  EXPECT_EQ(commit_of(path, feature, "a"), feature);
  const fs::path clone = repository.folder() / "clone";
  repository.shell("git clone -q . '" + clone.string() + "'");
  repository.shell("git -C '" + clone.string() + "' tag feature origin/main");
  EXPECT_THAT(complaint(clone, "feature"), HasSubstr("refs/remotes/origin/feature is commit"))
      << "a tag before a branch of the origin";
}

TEST(Git, ChecksOutACommitAlsoWhereAnOldCheckoutWasDeletedByHand) {
  const Repository repository;
  const fs::path folder = repository.folder() / "checkout";
  const std::string commit = commit_of(repository.path(), "feature", "a");
  for (int i = 0; i < 2; ++i) {
    check_out(repository.path(), commit, folder, "a");
    std::ifstream stream(folder / "team.sh");
    std::string text((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
    EXPECT_THAT(text, HasSubstr("two"));
    fs::remove_all(folder);
  }
}

TEST(Git, TellsAddressesFromFolders) {
  EXPECT_TRUE(is_remote("https://example.org/team.git"));
  EXPECT_TRUE(is_remote("git@example.org:team.git"));
  EXPECT_FALSE(is_remote("."));
  EXPECT_FALSE(is_remote("/home/me/a:b"));
}

TEST(Git, NeverRunsAProgramForAnAddress) {
  const Repository repository;
  const fs::path marker = repository.folder() / "marker";
  for (const std::string& address :
       {"ext::touch " + marker.string(), "--upload-pack=touch " + marker.string()}) {
    EXPECT_THROW(mirror(address, repository.folder() / "copy", "a"), std::invalid_argument);
  }
  EXPECT_FALSE(fs::exists(marker));
}

TEST(Git, LeavesNoTemporaryFile) {
  const Repository repository;
  const fs::path folder = repository.folder() / "it's `temporary`";
  fs::create_directory(folder);
  const char* before = std::getenv("TMPDIR");
  const std::string usual = before != nullptr ? before : "";
  ::setenv("TMPDIR", folder.c_str(), 1);
  const Said said = listen_to({"/bin/sh", "-c", "ls \"$TMPDIR\""}, {}, std::chrono::seconds{60});
  before != nullptr ? ::setenv("TMPDIR", usual.c_str(), 1) : ::unsetenv("TMPDIR");
  EXPECT_TRUE(said.well);
  EXPECT_EQ(said.text, "") << "nor while it runs: kill -9 would leave it";
}

TEST(ListenTo, EndsWhatTakesTooLong) {
  const Said said = listen_to({"/bin/sh", "-c", "echo begun; sleep 100"}, {}, std::chrono::milliseconds{300});
  EXPECT_FALSE(said.well);
  EXPECT_EQ(said.text, "begun\n");
}

}  // namespace
}  // namespace builds

#include "experiments/process/isolation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <string>

#include "experiments/process/child.h"
#include "experiments/process/tree.h"

namespace process {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

constexpr auto patience = 20s;  // for a loaded machine; nothing here needs more than milliseconds

class IsolationTest : public testing::Test {
 protected:
  IsolationTest() {
    for (const char* name : {"HOME", "PATH"}) {
      const char* value = std::getenv(name);
      before_.emplace_back(name, value != nullptr ? value : "");
    }
    fs::create_directories(home_ / "private");
    ::setenv("HOME", home_.c_str(), 1);
  }
  ~IsolationTest() override {
    for (const auto& [name, value] : before_) ::setenv(name.c_str(), value.c_str(), 1);
    remove_tree(folder_);
  }
  static bool possible() {
    static const IsolationLimit limit = isolation_limit();
    if (limit.strongest == Isolation::Network) return true;
    std::cout << "not isolated here: " << limit.problem << std::endl;
    return false;
  }
  static void make_program(const fs::path& file, const std::string& script) {
    fs::create_directories(file.parent_path());
    std::ofstream(file) << "#!/bin/sh\n" << script << '\n';
    fs::permissions(file, fs::perms::owner_all);
  }
  Command command(std::vector<std::string> arguments, Cell cell = {}) const {
    cell.level = Isolation::Network;
    Command command;
    command.arguments = std::move(arguments);
    command.output = folder_ / "output";
    command.cell = std::move(cell);
    return command;
  }
  std::string output() const {
    std::ifstream file(folder_ / "output");
    return {std::istreambuf_iterator<char>(file), {}};
  }
  /// What it prints.
  std::string said(const Command& command) {
    Child child(command);
    EXPECT_TRUE(child.wait(patience));
    child.stop(0ms);
    return output();
  }

  fs::path folder_ = fs::temp_directory_path() / ("cells-" + std::to_string(::getpid()));
  fs::path home_ = folder_ / "home";

 private:
  std::vector<std::pair<std::string, std::string>> before_;
};

TEST_F(IsolationTest, HasNames) {
  for (const Isolation level : {Isolation::None, Isolation::Files, Isolation::Network}) {
    EXPECT_EQ(isolation_from_name(name(level)), level);
  }
  EXPECT_FALSE(isolation_from_name("full"));
}

TEST_F(IsolationTest, ReportsExitCodesAndSignals) {
  if (!possible()) GTEST_SKIP();
  const auto end_of = [&](const std::string& script) {
    Child child(command({"/bin/sh", "-c", script}));
    EXPECT_TRUE(child.wait(patience));
    return child.stop(0ms).describe();
  };
  EXPECT_EQ(end_of("exit 0"), "ended with code 0");
  EXPECT_EQ(end_of("exit 3"), "ended with code 3");
  EXPECT_EQ(end_of("kill -SEGV $$"), "was ended by signal 11 (Segmentation fault)");
}

TEST_F(IsolationTest, SaysWhenTheProgramNeverBegan) {
  if (!possible()) GTEST_SKIP();
  make_program(folder_ / "orphan", "");
  std::ofstream(folder_ / "orphan") << "#!/nowhere/interpreter\n";
  Child child(command({(folder_ / "orphan").string()}));
  ASSERT_TRUE(child.wait(patience));
  EXPECT_FALSE(child.stop(0ms).began);
  EXPECT_THAT(output(), HasSubstr("bwrap: execvp"));
}

TEST_F(IsolationTest, TermReachesTheProgramAndLetsItEnd) {
  if (!possible()) GTEST_SKIP();
  Child child(command(
      {"/bin/sh", "-c", "trap 'echo goodbye; exit 5' TERM; echo ready; while :; do sleep 0.01; done"}));
  for (int i = 0; i < 2000 && output() != "ready\n"; ++i) child.wait(10ms);
  EXPECT_EQ(child.stop(patience).describe(), "ended with code 5");
  EXPECT_THAT(output(), HasSubstr("goodbye"));
}

TEST_F(IsolationTest, CountsWhatProgramsInItUsed) {
  if (!possible()) GTEST_SKIP();
  // Processor time of a child's child, all of it after the last look.
  Child child(command({"/bin/sh", "-c", "sh -c 'i=0; while [ $i -lt 300000 ]; do i=$((i+1)); done'"}));
  ASSERT_TRUE(child.wait(patience));
  EXPECT_GT(child.stop(0ms).user_seconds,
            0.02);  // a shell takes 0.1 s for it here, no machine a fifth of that
}

TEST_F(IsolationTest, HomeAndTemporaryFoldersAreItsOwnAndEmpty) {
  if (!possible()) GTEST_SKIP();
  const std::string all = said(command({"/bin/sh", "-c",
                                        "ls -A \"$HOME\" /tmp/x /run; touch \"$HOME/a\" /tmp/b && echo "
                                        "wrote; pwd; ls /proc | grep -c '^[0-9]'"}));
  EXPECT_THAT(all, Not(HasSubstr("private")));
  EXPECT_THAT(all, HasSubstr("wrote\n"));
  EXPECT_FALSE(fs::exists(home_ / "a"));
}

TEST_F(IsolationTest, InstallationsInTheHomeCanBeUsedByName) {
  if (!possible()) GTEST_SKIP();
  // As pyenv does it: what PATH finds is a script that starts the program proper elsewhere in its folder.
  make_program(home_ / ".tool/versions/1/bin/speak", "echo spoken");
  make_program(home_ / ".tool/shims/speak",
               "exec \"" + (home_ / ".tool/versions/1/bin/speak").string() + "\"");
  make_program(home_ / "bin/other", "exec speak");
  ::setenv("PATH",
           ((home_ / ".tool/shims").string() + ":" + (home_ / "bin").string() + ":/usr/bin:/bin").c_str(), 1);
  EXPECT_EQ(said(command({"speak"})), "spoken\n");
  EXPECT_EQ(said(command({"other"})), "spoken\n");
  EXPECT_EQ(said(command({(home_ / "bin/other").string()})), "spoken\n");
}

TEST_F(IsolationTest, VisibleHiddenAndWritableFolders) {
  if (!possible()) GTEST_SKIP();
  for (const char* name : {"results", "results/mine", "models"}) {
    fs::create_directories(folder_ / name);
    std::ofstream(folder_ / name / "file") << name << '\n';
  }
  Cell cell;
  cell.hidden = {folder_ / "results"};
  cell.visible = {folder_ / "models"};
  cell.writable = {folder_ / "results/mine"};
  const std::string all = said(command(
      {"/bin/sh", "-c",
       "cd \"" + folder_.string() +
           "\"; cat results/file models/file results/mine/file; "
           "touch results/a && echo bad; touch models/a && echo bad; touch results/mine/a && echo good"},
      cell));
  EXPECT_THAT(all, HasSubstr("models\nresults/mine\n"));
  EXPECT_THAT(all, Not(HasSubstr("results\n")));
  EXPECT_THAT(all, Not(HasSubstr("bad")));
  EXPECT_THAT(all, HasSubstr("good"));
  EXPECT_TRUE(fs::exists(folder_ / "results/mine/a"));
}

TEST_F(IsolationTest, OfAHiddenFolderInAnEmptyOneNotEvenTheNameIsSeen) {
  if (!possible()) GTEST_SKIP();
  fs::create_directories(folder_ / "socket");
  fs::create_directories(folder_ / "results" / "mine");
  Cell cell;
  cell.hidden = {folder_ / "socket", folder_ / "results"};
  cell.writable = {folder_ / "results" / "mine"};
  EXPECT_EQ(said(command({"/bin/sh", "-c", "cd; cd ..; ls"}, cell)), "home\nresults\n");
  cell.visible = {folder_};
  const std::string all = said(command(
      {"/bin/sh", "-c", "ls -A \"$0\"/socket; touch \"$0\"/socket/a && echo bad", folder_.string()}, cell));
  EXPECT_THAT(all, Not(HasSubstr("bad"))) << "seen, it is empty and cannot be written";
}

// Root needs no capability for most files in /proc/sys, and no namespace of its own changes that.
TEST_F(IsolationTest, NothingOfTheKernelCanBeSet) {
  if (!possible()) GTEST_SKIP();
  // Opened only: nothing is changed where it can be done.
  const std::string script =
      "cd /proc; for place in [!0-9]*; do [ -L $place ] || find $place -type f -writable; done; "
      "for file in sys/kernel/core_pattern sys/vm/overcommit_memory; do : >> $file && echo wrote $file; "
      "done; echo end";
  const auto all = [&](Isolation level) {
    Command looked = command({"/bin/bash", "-c", script});
    looked.cell->level = level;
    looked.errors_apart = true;
    return said(looked);
  };
  EXPECT_EQ(all(Isolation::Files), "end\n");
  EXPECT_EQ(all(Isolation::Network), "end\n");
}

// Who is root in one can mount: control groups, with which a group is ended as a whole, or memory without end.
TEST_F(IsolationTest, NoNamespaceCanBeMade) {
  if (!possible()) GTEST_SKIP();
  if (!isolation_limit().gap.empty()) GTEST_SKIP() << isolation_limit().gap;
  const std::string script =
      "for what in --user --mount --cgroup --pid --net; do unshare $what true && echo made $what; done; "
      "cd; for type in cgroup2 tmpfs; do mkdir $type; mount -t $type none $type && echo mounted $type; "
      "unshare --user --map-root-user --mount --cgroup mount -t $type none $type && echo mounted $type; "
      "done; "
      "echo end";
  const std::string all = said(command({"/bin/sh", "-c", script}));
  EXPECT_THAT(all, Not(HasSubstr("made")));
  EXPECT_THAT(all, Not(HasSubstr("mounted")));
  EXPECT_THAT(all, Not(HasSubstr("cannot create directory")));
  EXPECT_THAT(all, HasSubstr("end\n"));
}

TEST_F(IsolationTest, SaysWhenNamespacesCannotBeForbidden) {
  if (!possible()) GTEST_SKIP();
  // As one before 0.8.0, in whose file that option is not found.
  make_program(home_ / "bwrap", "exec \"" + find_program("bwrap").string() + "\" \"$@\"");
  ::setenv("PATH", (home_.string() + ":/usr/bin:/bin").c_str(), 1);
  EXPECT_EQ(isolation_limit().strongest, Isolation::Network);
  EXPECT_THAT(isolation_limit().gap, HasSubstr("programs can make namespaces of their own"));
  EXPECT_EQ(said(command({"/bin/echo", "it runs"})), "it runs\n");
}

TEST_F(IsolationTest, OnlyFoldersThatAreNotSharedCanBeHidden) {
  for (const char* name : {"a", "b", "b/inner", "common"}) fs::create_directories(folder_ / name);
  const fs::path a = folder_ / "a";
  const fs::path b = folder_ / "b";
  EXPECT_THAT(not_shared({b, "/usr/bin", "/tmp", folder_ / "nothing"}, {a}, a), ElementsAre(b));
  EXPECT_THAT(not_shared({b}, {b}, a), IsEmpty());
  EXPECT_THAT(not_shared({b}, {b / "inner"}, a), IsEmpty()) << "it would lose what lies beside its program";
  EXPECT_THAT(not_shared({b}, {a}, b / "inner"), IsEmpty()) << "it works there";
  ::setenv("PATH", (b / "bin").c_str(), 1);
  fs::create_directories(b / "bin");
  EXPECT_THAT(not_shared({b}, {a}, a), IsEmpty()) << "programs are found there by name";
}

TEST_F(IsolationTest, NeedsItsProgramAndWhatItsArgumentsName) {
  make_program(folder_ / "team/bin/play", "");
  std::ofstream(folder_ / "model") << "x";
  EXPECT_THAT(needed_folders(
                  {(folder_ / "team/bin/play").string(), "--model=" + (folder_ / "model").string(), "7"}, {}),
              ElementsAre(folder_ / "team/bin", folder_ / "team", folder_));
  const std::string told = "cd /nowhere; exec " + (folder_ / "team/bin/play").string() + " 7";
  EXPECT_THAT(needed_folders({"/usr/bin/env", "sh", "-c", told}, {}), Contains(folder_ / "team/bin"));
  EXPECT_THAT(needed_folders({"/nowhere/program"}, {}), IsEmpty());
}

TEST_F(IsolationTest, SaysWhatIsMissing) {
  ::setenv("PATH", home_.c_str(), 1);
  const IsolationLimit limit = isolation_limit();
  EXPECT_EQ(limit.strongest, Isolation::None);
  EXPECT_THAT(limit.problem, HasSubstr("bubblewrap is not installed"));
  make_program(home_ / "bwrap", "echo 'bwrap: not allowed here' >&2; exit 1");
  EXPECT_EQ(isolation_limit().strongest, Isolation::None);
  EXPECT_EQ(isolation_limit().problem, "bwrap: not allowed here");
}

}  // namespace
}  // namespace process

#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "experiments/record/ledger.h"
#include "experiments/runner/program_files.h"
#include "experiments/runner/run.h"
#include "experiments/runner/status.h"
#include "tests/experiments/runner/support.h"
#include "tests/fakes/programs.h"

namespace runner {

namespace fs = std::filesystem;

/// Runs of the small design with the fake worker, in a folder of their own.
class RunTest : public testing::Test {
 protected:
  /// Runs that are killed leave their temporary files; here they go with the test's folder.
  void SetUp() override {
    fs::create_directories(folder_.path() / "tmp");
    ::setenv("TMPDIR", (folder_.path() / "tmp").c_str(), 1);
  }
  void TearDown() override { ::unsetenv("TMPDIR"); }

  /// Options with a fake worker of these arguments, in a folder of its own.
  RunOptions options(const std::string& folder, std::vector<std::string> arguments = {}) const {
    RunOptions options;
    options.out = folder_.path() / folder;
    options.workers = 2;
    options.worker_command = {fakes::bin_dir() + "/fake_worker"};
    options.worker_command.insert(options.worker_command.end(), arguments.begin(), arguments.end());
    options.preflight = false;  // it would play with the fake worker, too; see RunPreflight
    options.grace = std::chrono::milliseconds{50};
    options.housekeeping = std::chrono::milliseconds{20};
    options.limits.faults_in_a_row = 100;
    options.limits.fault_share = 1;
    options.limits.free_disk = 0;
    options.limits.sampled = 0;
    options.limits.audited = 0;
    return options;
  }

  Ending play(const RunOptions& options) {
    std::ostringstream said;
    const RunResult result = run(design_, options, said);
    said_ = said.str();
    return result.ending;
  }

  /// What a run dies of.
  std::string complaint(const RunOptions& options) {
    try {
      play(options);
    } catch (const record::StorageError& error) {
      return error.what();
    }
    return "none";
  }

  /// A run in a process of its own, as the user has it.
  pid_t play_elsewhere(const RunOptions& options) const {
    const pid_t child = ::fork();
    if (child == 0) {
      std::ofstream nowhere("/dev/null");
      try {
        const RunResult result = run(design_, options, nowhere);
        ::_exit(result.ending == Ending::Interrupted ? 128 + result.signal : 0);
      } catch (const std::exception& error) {
        std::cerr << error.what() << '\n';
        ::_exit(99);
      }
    }
    return child;
  }

  /// All attempts without what may differ from run to run.
  std::vector<record::Attempt> table(const std::string& folder) const {
    auto attempts = record::Ledger::read(folder_.path() / folder / "ledger.sqlite").attempts();
    for (record::Attempt& attempt : attempts) {
      attempt.started.clear();
      attempt.worker = 0;
      attempt.record.wall_seconds = 0;
      attempt.record.costs.clear();
    }
    return attempts;
  }

  /// The attempts that count. A game that was void before its partner was started spares the partner; which
  /// one comes first is a matter of time, so voids are not compared.
  static std::vector<record::Attempt> counted(const std::vector<record::Attempt>& attempts) {
    std::vector<record::Attempt> result;
    std::map<std::pair<std::string, int>, std::vector<const record::Attempt*>> pairs;
    for (const auto& one : attempts) pairs[{one.key.condition, one.key.pair}].push_back(&one);
    for (const auto& [key, all] : pairs) {
      const record::PairState state = record::pair_state(all);
      EXPECT_TRUE(state.complete());
      for (const record::Attempt* leg : state.legs) {
        if (leg != nullptr) result.push_back(*leg);
      }
    }
    return result;
  }

  /// Processes whose command line names the folder of this test: workers that are still there.
  int left_over() const {
    int count = 0;
    for (const auto& entry : fs::directory_iterator("/proc")) {
      std::ifstream stream(entry.path() / "cmdline");
      std::string text((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
      if (text.find(folder_.path().string()) != std::string::npos) ++count;
    }
    return count;
  }

  /// Killed processes take a moment to go.
  bool nobody_left() const {
    for (int i = 0; i < 200; ++i) {
      if (left_over() == 0) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
  }

  TemporaryFolder folder_;
  schedule::Design design_ = small_design(4);
  std::string said_;
};

}  // namespace runner

#pragma once

#include <gtest/gtest.h>
#include <stdlib.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>

#include "experiments/process/filter.h"
#include "tests/fakes/programs.h"

namespace fs = std::filesystem;

struct Said {
  int code = -1;
  std::string text;  ///< standard output and error
};

/// The program in a folder that goes away with the test.
class MatchdayProgram : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "cli-test-XXXXXX").string();
    ASSERT_NE(::mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  void TearDown() override { fs::remove_all(folder_); }

  Said matchday(const std::string& arguments) const { return shell("\"$BIN\"/matchday " + arguments); }

  /// A line for the shell in our folder; $BIN is the folder of the programs.
  Said shell(const std::string& line) const {
    const std::string with_code = "(" + line + "); code=$?; printf '%03d' $code";
    std::string text = process::filter({.arguments = {"/bin/sh", "-c", with_code},
                                        .directory = folder_,
                                        .environment = {{"BIN", fakes::bin_dir()}},
                                        .patience = std::chrono::seconds{300},
                                        .errors_too = true})
                           .output;
    Said said;
    constexpr std::size_t digits = 3;
    if (text.size() < digits) return said;
    said.code = std::stoi(text.substr(text.size() - digits));
    said.text = text.substr(0, text.size() - digits);
    return said;
  }

  /// A design of eight quick games; `more` goes to the top of it.
  void write_design(const std::string& name, const std::string& more = "") const {
    std::ofstream(folder_ / name)
        << "name = \"small\"\n"
        << more << "pairs = 2\n[teams.a]\ncommand = \"true\"\n[teams.b]\ncommand = \"true\"\n"
        << "[[conditions]]\nname = \"one\"\n[[conditions]]\nname = \"two\"\n";
  }

  static std::string fake(const std::string& arguments = "") {
    return " --worker '" + fakes::bin_dir() + "/fake_worker " + arguments + "'";
  }

  fs::path folder_;
};

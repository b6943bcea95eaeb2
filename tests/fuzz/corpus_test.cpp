// Every target over its corpus: the seeds, and whatever once was a finding.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <vector>

#include "tests/fuzz/support.h"
#include "tests/fuzz/target.h"

namespace {

namespace fs = std::filesystem;

struct Target {
  const char* name;
  bool (*function)(std::string_view);
};

constexpr std::array targets = {
    Target{"channel", fuzz::channel},
    Target{"config_json", fuzz::config_json},
    Target{"design", fuzz::design},
    Target{"judged_game", fuzz::judged_game},
    Target{"judged_result", fuzz::judged_result},
    Target{"league_log", fuzz::league_log},
    Target{"league_log_gz", fuzz::league_log_gz},
    Target{"realism", fuzz::realism},
    Target{"record_json", fuzz::record_json},
    Target{"recorded_game", fuzz::recorded_game},
    Target{"recording", fuzz::recording},
    Target{"referee", fuzz::referee},
    Target{"reported", fuzz::reported},
    Target{"robot_control", fuzz::robot_control},
    Target{"simulator", fuzz::simulator},
    Target{"snippet", fuzz::snippet},
    Target{"vision", fuzz::vision},
};

const fs::path folder = fs::path(SOURCE_DIR) / "tests/fuzz";

std::string bytes_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<fs::path> corpus_of(const std::string& target) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder / "corpus" / target)) files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

class Corpus : public testing::TestWithParam<Target> {};

// The seeds are named good_*: they must reach what is behind the decoder, or they have rotted.
TEST_P(Corpus, IsDecodedOrRefusedInASentence) {
  fuzz::silence_protobuf();
  const std::vector<fs::path> files = corpus_of(GetParam().name);
  int good = 0;
  for (const fs::path& file : files) {
    SCOPED_TRACE(file.string());
    bool understood = false;
    ASSERT_NO_THROW(understood = GetParam().function(bytes_of(file)));
    if (!file.filename().string().starts_with("good_")) continue;
    ++good;
    EXPECT_TRUE(understood) << file << " is not understood any more; write it again with make_corpus";
  }
  EXPECT_GT(good, 0) << "no seed in " << folder / "corpus" / GetParam().name;
}

INSTANTIATE_TEST_SUITE_P(All, Corpus, testing::ValuesIn(targets),
                         [](const auto& its) { return std::string(its.param.name); });

TEST(Corpora, EveryTargetOfTheListIsRunHere) {
  std::vector<std::string> listed;
  std::ifstream list(folder / "targets.txt");
  for (std::string line; std::getline(list, line);) {
    if (line.empty() || line.front() == '#') continue;
    std::istringstream(line) >> listed.emplace_back();
  }
  std::ranges::sort(listed);
  std::vector<std::string> run;
  for (const Target& target : targets) run.emplace_back(target.name);
  EXPECT_EQ(listed, run);
}

}  // namespace

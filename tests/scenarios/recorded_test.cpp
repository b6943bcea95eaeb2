// Passages of judged games that were once called wrongly, or might be: images as they were delivered, the
// truth as expectation. Each FILE.json of the folder `recorded` is one test, with FILE.log.gz beside it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "autoref/log.h"
#include "experiments/judge/failures.h"
#include "experiments/judge/shadow.h"
#include "experiments/judge/snippet.h"

namespace scenarios {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> recorded() {
  std::vector<fs::path> files;
  for (const fs::directory_entry& file : fs::directory_iterator(SOURCE_DIR "/tests/scenarios/recorded")) {
    if (file.path().extension() == ".json") files.push_back(file.path());
  }
  std::ranges::sort(files);
  return files;
}

std::string test_name(const ::testing::TestParamInfo<fs::path>& file) {
  std::string name = file.param.stem().string();
  for (char& letter : name) {
    if (std::isalnum(static_cast<unsigned char>(letter)) == 0) letter = '_';
  }
  return name;
}

/// The detectors of the rule set in the acting referee's states, on the recorded images.
std::vector<judge::Call> calls_of(const judge::Snippet& snippet, const fs::path& log) {
  const autoref::Survey survey = autoref::survey_log(log);
  judge::Shadow shadow("it", survey.geometry.value(), world::rule_set(snippet.rules));
  const judge::Timeline timeline = snippet.timeline();
  world::Time before;
  autoref::Listener listener;
  listener.batch = [&](std::span<const world::Detection> images) {
    world::Time newest = before;
    for (const world::Detection& image : images) newest = std::max(newest, image.t_capture);
    const bool by_hand = std::ranges::any_of(
        snippet.by_hand, [&](world::Time time) { return time > before && time <= newest; });
    shadow.see(images, timeline, by_hand);
    before = newest;
  };
  const autoref::LogCount count = autoref::read_log(log, survey, listener);
  EXPECT_EQ(count.defect, "");
  return shadow.calls();
}

class RecordedScenario : public ::testing::TestWithParam<fs::path> {};

TEST_P(RecordedScenario, IsCalledAsItWas) {
  const judge::Snippet snippet = judge::read_snippet(GetParam());
  const std::vector<judge::Case> cases = snippet.judge(calls_of(snippet, judge::log_of(GetParam())));
  int compared = 0;
  for (const judge::Case& one : cases) {
    if (one.close() || one.ambiguous()) continue;
    ++compared;
    EXPECT_EQ(one.result, judge::Result::Found) << snippet.game << ": " << judge::name(one.event) << " "
                                                << judge::name(one.result) << "; " << judge::sentence(one);
    if (one.event == judge::Event::Exit && one.result == judge::Result::Found) {
      EXPECT_TRUE(one.team_is_right()) << snippet.game << ": last touch wrong; " << judge::sentence(one);
    }
  }
  // A passage may show that nothing happened; then no call may be the expectation.
  const bool something = std::ranges::any_of(snippet.truth, [&](const judge::TrueEvent& event) {
    return event.margin >= 1 && !event.ambiguous && !event.late && event.time >= snippet.from &&
           event.time <= snippet.to && std::ranges::find(snippet.events, event.event) != snippet.events.end();
  });
  EXPECT_EQ(compared > 0, something);
}

INSTANTIATE_TEST_SUITE_P(Folder, RecordedScenario, ::testing::ValuesIn(recorded()), test_name);

}  // namespace
}  // namespace scenarios

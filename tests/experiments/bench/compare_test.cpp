#include "experiments/bench/compare.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace bench {
namespace {

using testing::AllOf;
using testing::HasSubstr;

Figures example() {
  Figures figures;
  figures.realism = "measured";
  figures.hash = "abc";
  figures.ticks = 6000;
  figures.loop_seconds = 2;
  figures.host_cpu = 0.75;
  figures.teams_cpu = 0.5;
  figures.reference_tick = 25e-6;
  figures.rows = {{"physics", 30e-6, 20e-6, 90e-6}, {"channel", 10e-6}};
  figures.sum = 40e-6;
  figures.memory_host = 10 << 20;
  figures.memory_yellow = figures.memory_blue = 5 << 20;
  figures.messages_per_tick = 4;
  figures.calls_per_tick = 4;
  figures.switches_per_tick = 3;
  figures.scaling = Scaling{2, 500, 980};
  return figures;
}

std::string complaint(const std::string& text) {
  try {
    figures_from_json(text, "old.json");
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "none";
}

TEST(Figures, ReadBackAreThoseThatWereWritten) {
  const Figures read = figures_from_json(json(example()), "old.json");
  // All of it but medians and quantiles, which are not read, to the digits that are shown.
  Figures plain = example();
  for (Row& row : plain.rows) row.median = row.ninety_nine = -1;
  EXPECT_EQ(table(read), table(plain));
  EXPECT_EQ(comparison(read, plain), comparison(plain, plain));
}

TEST(Figures, OfADamagedOrForeignFileAreRefusedWithItsNameAndField) {
  const std::string good = json(example());
  EXPECT_THAT(complaint(good.substr(0, good.size() / 2)),
              AllOf(HasSubstr("old.json"), HasSubstr("not JSON")));
  EXPECT_THAT(complaint(""), HasSubstr("not JSON"));
  EXPECT_THAT(complaint("[1, 2]"), HasSubstr("not JSON"));
  EXPECT_THAT(complaint("{\"ticks\": 5}"), HasSubstr("made_by"));
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
  };
  EXPECT_THAT(complaint(with("\"format\": 1", "\"format\": 9")),
              HasSubstr("format is 9, this matchday reads 1"));
  EXPECT_THAT(complaint(with("\"ticks\": 6000", "\"ticks\": \"many\"")), HasSubstr("ticks is not a number"));
  EXPECT_THAT(complaint(with("\"ticks\": 6000", "\"ticks\": 0")), HasSubstr("ticks is 0"));
  EXPECT_THAT(complaint(with("\"mean_us\": 30.0", "\"mean_us\": null")), HasSubstr("parts.physics.mean_us"));
  EXPECT_THAT(complaint(with("\"mean_us\"", "\"mean\"")), HasSubstr("parts.physics.mean_us is missing"));
  EXPECT_THAT(complaint(with("\"workers\": 2", "\"workers\": -2")), HasSubstr("scaling.workers is -2"));
}

// On a machine twice as slow everything takes twice as long, the reference scene too: nothing has changed.
TEST(Comparison, IsOfRatiosToTheReferenceScene) {
  Figures slow = example();
  slow.reference_tick *= 2;
  for (Row& row : slow.rows) row.mean *= 2;
  EXPECT_THAT(comparison(example(), slow),
              HasSubstr("physics                              1.200         1.200   1.000"));
  Figures better = example();
  better.rows[0].mean /= 2;
  EXPECT_THAT(comparison(example(), better),
              HasSubstr("physics                              1.200         0.600   0.500"));
  EXPECT_THAT(comparison(example(), better), HasSubstr("games per hour, 2 workers"));
}

TEST(Comparison, SaysWhenThePlayIsNotTheSame) {
  Figures other = example();
  EXPECT_THAT(comparison(example(), other), testing::Not(HasSubstr("differ")));
  other.hash = "def";
  EXPECT_THAT(comparison(example(), other), HasSubstr("The games differ"));
}

TEST(Comparison, ShowsPartsThatOnlyOneOfThemHas) {
  Figures other = example();
  other.rows.push_back({"log", 5e-6});
  EXPECT_THAT(comparison(example(), other), HasSubstr("log"));
  EXPECT_THAT(comparison(other, example()), HasSubstr("log"));
}

}  // namespace
}  // namespace bench

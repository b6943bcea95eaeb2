#include "experiments/report/figures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/experiments/report/examples.h"

namespace report {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

TEST(Figures, OfASweepAreGoalsDifferenceAndResults) {
  const std::vector<Figure> found = figures(sweep_example());
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[0].name, "speed-goals");
  EXPECT_EQ(found[1].name, "speed-difference");
  EXPECT_EQ(found[2].name, "speed-results");
  EXPECT_THAT(found[0].script, HasSubstr("set xlabel \"b.speed_factor\""));
  EXPECT_THAT(found[1].script, HasSubstr("\n0.6 2 "));  // x, mean difference
  EXPECT_THAT(found[1].script, HasSubstr("title 'trend'"));
}

TEST(Figures, OfOtherConditionsHaveTheirNamesOnTheAxis) {
  const std::vector<Figure> found = figures(example());
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[0].name, "conditions-goals");
  EXPECT_THAT(found[0].script, HasSubstr("\"hindered\" 1"));
}

TEST(Figures, AreNoneWithoutGames) { EXPECT_TRUE(figures(summarise(example_header(), {})).empty()); }

TEST(Figures, QuoteNames) {
  Header header = example_header();
  header.conditions[0].a.name = "the \"best\" \\ one";
  Summary summary = example();
  summary.rows[0].a.name = summary.rows[1].a.name = "the \"best\" \\ one";
  EXPECT_THAT(figures(summary)[0].script, HasSubstr("\"A the \\\"best\\\" \\\\ one\""));
}

TEST(Drawn, IsAnSvg) {
  if (std::system("command -v gnuplot > /dev/null") != 0) GTEST_SKIP() << "gnuplot is not installed";
  for (const Figure& figure : figures(sweep_example())) {
    const std::string svg = drawn(figure);
    EXPECT_THAT(svg, HasSubstr("<svg"));
    EXPECT_THAT(svg, HasSubstr("</svg>"));
  }
}

TEST(Drawn, SaysInOneSentenceThatGnuplotIsMissing) {
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", "/nonexistent", 1);
  try {
    drawn(figures(sweep_example())[0]);
    ADD_FAILURE() << "nothing thrown";
  } catch (const DrawingError& error) {
    EXPECT_THAT(error.what(), HasSubstr("gnuplot, which is not installed"));
  }
  ::setenv("PATH", path.c_str(), 1);
}

TEST(Drawn, SaysWhichFigureCouldNotBeDrawn) {
  if (std::system("command -v gnuplot > /dev/null") != 0) GTEST_SKIP() << "gnuplot is not installed";
  try {
    drawn({"odd", "", "plot nonsense"});
    ADD_FAILURE() << "nothing thrown";
  } catch (const DrawingError& error) {
    EXPECT_THAT(error.what(), StartsWith("figure odd:"));
  }
}

}  // namespace
}  // namespace report

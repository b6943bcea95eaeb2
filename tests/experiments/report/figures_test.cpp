#include "experiments/report/figures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>

#include "experiments/process/filter.h"
#include "tests/experiments/report/examples.h"

namespace report {
namespace {

using testing::AnyOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

bool gnuplot_is_there() {
  try {
    process::find_program("gnuplot");
    return true;
  } catch (const process::StartError&) {
    return false;
  }
}

TEST(Figures, OfASweepAreGoalsDifferenceAndResults) {
  const std::vector<Figure> found = figures(sweep_example());
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[0].name, "speed-goals");
  EXPECT_EQ(found[1].name, "speed-difference");
  EXPECT_EQ(found[2].name, "speed-results");
  EXPECT_EQ(found[0].drawing.x_label, "b.speed_factor");
  ASSERT_EQ(found[1].drawing.curves.size(), 1U);
  const Drawing::Value& value = found[1].drawing.curves[0].points.at(1);
  EXPECT_DOUBLE_EQ(value.x, 0.6);
  EXPECT_DOUBLE_EQ(value.y, 2);
  EXPECT_TRUE(found[1].drawing.trend.has_value());
}

TEST(Figures, OfOtherConditionsHaveTheirNamesOnTheAxis) {
  const std::vector<Figure> found = figures(example());
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[0].name, "conditions-goals");
  ASSERT_EQ(found[0].drawing.ticks.size(), 2U);
  EXPECT_EQ(found[0].drawing.ticks[1].label, "hindered");
}

TEST(Figures, AreNoneWithoutGames) { EXPECT_TRUE(figures(summarise(example_header(), {})).empty()); }

TEST(Figures, HaveNamesThatStayInTheirFolder) {
  Summary summary = sweep_example();
  summary.sweeps[0].name = "../../etc/cron.d";
  EXPECT_EQ(figures(summary)[0].name, "-.-..-etc-cron.d-goals");
}

TEST(Drawn, IsAnSvg) {
  if (!gnuplot_is_there()) GTEST_SKIP() << "gnuplot is not installed";
  for (const Figure& figure : figures(sweep_example())) {
    const std::string svg = drawn(figure);
    EXPECT_THAT(svg, HasSubstr("<svg"));
    EXPECT_THAT(svg, HasSubstr("</svg>"));
    EXPECT_THAT(svg, HasSubstr("<text>b.speed_factor</text>"));
    EXPECT_THAT(svg, HasSubstr("<text>0.6</text>"));
    EXPECT_THAT(svg, Not(HasSubstr("\xEE\x80"))) << "every stand-in is replaced";
  }
}

/// A folder in which we are while it lives; what a name could run would leave a file there.
class Place {
 public:
  Place() : before_(std::filesystem::current_path()) {
    std::string name = (std::filesystem::temp_directory_path() / "figures-test-XXXXXX").string();
    EXPECT_NE(::mkdtemp(name.data()), nullptr);
    path_ = name;
    std::filesystem::current_path(path_);
  }
  Place(const Place&) = delete;
  Place& operator=(const Place&) = delete;
  ~Place() {
    std::filesystem::current_path(before_);
    std::filesystem::remove_all(path_);
  }
  std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(path_))
      names.push_back(entry.path().filename());
    return names;
  }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path before_;
  std::filesystem::path path_;
};

struct Name {
  std::string name;
  std::string shown;  ///< in the SVG
};
void PrintTo(const Name& name, std::ostream* out) { *out << name.name; }

class DrawnName : public testing::TestWithParam<Name> {};

TEST_P(DrawnName, IsTextAndNothingElse) {
  if (!gnuplot_is_there()) GTEST_SKIP() << "gnuplot is not installed";
  const Place place;
  Summary summary = example();  // everything that may have been written by others
  for (Row& row : summary.rows) row.a.name = row.b.name = row.condition = GetParam().name;
  for (const Figure& figure : figures(summary)) {
    const std::string svg = drawn(figure);
    EXPECT_THAT(svg, HasSubstr("<text>" + GetParam().shown + "</text>")) << "the condition, on the axis";
  }
  const std::string title = "<text>A " + GetParam().shown + "</text>";
  const std::string cut = "...</text>";  // of the longer ones
  EXPECT_THAT(drawn(figures(summary)[0]), AnyOf(HasSubstr(title), HasSubstr(cut)));
  Summary sweep = sweep_example();
  sweep.sweeps[0].key = sweep.sweeps[0].name = GetParam().name;
  for (const Figure& figure : figures(sweep)) {
    EXPECT_THAT(drawn(figure), HasSubstr("<text>" + GetParam().shown + "</text>")) << "below the axis";
  }
  EXPECT_THAT(place.files(), ElementsAre());
}

INSTANTIATE_TEST_SUITE_P(
    All, DrawnName,
    testing::Values(Name{"`touch marker`", "`touch marker`"}, Name{"$(touch marker)", "$(touch marker)"},
                    Name{"\"; system 'touch marker' #", "&quot;; system &#39;touch marker&#39; #"},
                    Name{"' ; !touch marker", "&#39; ; !touch marker"},
                    Name{"\\\"`touch marker`", "\\&quot;`touch marker`"},
                    Name{"@ARGV @GPVAL_PWD", "@ARGV @GPVAL_PWD"}, Name{"<touch marker", "&lt;touch marker"},
                    Name{"<script>alert(1)</script>&amp;", "&lt;script&gt;alert(1)&lt;/script&gt;&amp;amp;"},
                    Name{"a\n!touch marker\n", "a !touch marker "}, Name{"# no comment", "# no comment"},
                    Name{"a\tb\t", "a b "}, Name{"x_{1}^2 {/Symbol a} ~a{b}", "x_{1}^2 {/Symbol a} ~a{b}"},
                    Name{"%s%n%d \\n \\101", "%s%n%d \\n \\101"}, Name{"1/0 NaN", "1/0 NaN"},
                    Name{"\x1B[2J\xFF", "\xEF\xBF\xBD[2J\xEF\xBF\xBD"},
                    Name{"\xEE\x80\x80\xEE\x80\x81", "\xEE\x80\x80\xEE\x80\x81"}));

TEST(Drawn, CutsALongNameSoThatItFits) {
  if (!gnuplot_is_there()) GTEST_SKIP() << "gnuplot is not installed";
  Summary summary = example();
  for (Row& row : summary.rows) row.a.name = row.condition = std::string(5000, 'x');
  const std::string svg = drawn(figures(summary)[0]);
  EXPECT_THAT(svg, HasSubstr("<text>" + std::string(37, 'x') + "...</text>")) << "on the axis";
  EXPECT_THAT(svg, HasSubstr("<text>A " + std::string(25, 'x') + "...</text>")) << "in the legend";
}

TEST(Drawn, LeavesNoFileAndTakesAnyFolderForTemporaryFiles) {
  if (!gnuplot_is_there()) GTEST_SKIP() << "gnuplot is not installed";
  const Place place;
  const std::string folder = place.path() / "it's a `touch marker` \"folder\" $(touch marker)";
  std::filesystem::create_directory(folder);
  const char* before = std::getenv("TMPDIR");
  const std::string usual = before != nullptr ? before : "";
  ::setenv("TMPDIR", folder.c_str(), 1);
  EXPECT_THAT(drawn(figures(example())[0]), HasSubstr("</svg>"));
  before != nullptr ? ::setenv("TMPDIR", usual.c_str(), 1) : ::unsetenv("TMPDIR");
  EXPECT_EQ(place.files().size(), 1U) << "the folder";
  EXPECT_TRUE(std::filesystem::is_empty(folder));
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
  const Place place;
  // A gnuplot that breaks off.
  std::filesystem::create_symlink("/bin/false", place.path() / "gnuplot");
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", place.path().c_str(), 1);
  try {
    drawn(figures(sweep_example())[0]);
    ADD_FAILURE() << "nothing thrown";
  } catch (const DrawingError& error) {
    EXPECT_STREQ(error.what(), "figure speed-goals: gnuplot did not draw it: it ended with code 1");
  }
  ::setenv("PATH", path.c_str(), 1);
}

}  // namespace
}  // namespace report

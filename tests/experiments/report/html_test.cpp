#include "experiments/report/html.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <sstream>
#include <system_error>

#include "experiments/record/ledger.h"
#include "tests/experiments/report/examples.h"

namespace report {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

Page page_of(const Summary& summary, std::span<const record::Attempt> attempts) {
  Page page;
  page.summary = summary;
  page.health = health_of(attempts);
  page.attempts = attempts;
  page.made = "2026-11-21 21:00:00 UTC";
  return page;
}

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t found = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++found;
  return found;
}

TEST(Html, ShowsResultsStatisticsHealthAndGames) {
  const std::vector<record::Attempt> games = {with_statistics(game("equal", 0, 0, 3, 0), 5),
                                              with_statistics(game("equal", 0, 1, 2, 2), 6)};
  const std::string text = as_html(page_of(summarise(example_header(), games), games));
  for (const char* title : {"<h2>Results", "<h2>Match statistics", "<h2>Health of the run", "<h2>Games"}) {
    EXPECT_THAT(text, HasSubstr(title));
  }
  EXPECT_THAT(text, HasSubstr("equal-0000-1"));
  EXPECT_THAT(text, HasSubstr("shots on target"));
}

TEST(Html, ShowsWhatTheAuditsFound) {
  Summary summary = example();
  EXPECT_THAT(as_html(page_of(summary, {})), HasSubstr("No game was played again"));
  for (int pair = 0; pair < 7; ++pair) {
    const auto verdict = pair == 6 ? record::Verdict::SimulatorDiffers : record::Verdict::TeamDiffers;
    summary.header.audits.push_back({{"equal", pair, 0}, 1, verdict, "", ""});
  }
  const std::string text = as_html(page_of(summary, {}));
  EXPECT_THAT(text, HasSubstr("7 games were played again to compare hashes"));
  EXPECT_THAT(text, HasSubstr("equal-0003-0, equal-0004-0, ...</td>")) << "five are named, the sixth is not";
  EXPECT_THAT(text, HasSubstr("<td>6</td>"));
  EXPECT_THAT(text, HasSubstr("A MISTAKE OF MATCHDAY"));
  EXPECT_THAT(text, Not(HasSubstr("the same hash</td>")));
}

// Opens from a disk without a network: nothing is loaded from anywhere.
TEST(Html, NeedsNothingButItself) {
  Page page = page_of(sweep_example(), {});
  page.figures.emplace_back(Figure{"speed", "a figure", {}}, "<?xml version=\"1.0\"?>\n<svg><path/></svg>");
  const std::string text = as_html(page);
  EXPECT_EQ(count(text, "src="), 0U);
  EXPECT_EQ(count(text, "<link"), 0U);
  EXPECT_EQ(count(text, "@import"), 0U);
  EXPECT_EQ(count(text, "url("), 0U);
  EXPECT_THAT(text, HasSubstr("<svg><path/></svg><figcaption>a figure"));
  EXPECT_THAT(text, Not(HasSubstr("<?xml")));
}

TEST(Html, ClosesWhatItOpens) {
  const std::vector<record::Attempt> games = {forfeit_by_a(with_statistics(game("equal", 0, 0, 3, 0), 5)),
                                              game("equal", 0, 1, 2, 2), spoilt(game("equal", 1, 0, 0, 0))};
  Page page = page_of(summarise(example_header(), games), games);
  page.summary.header.audits = {{{"equal", 0, 0}, 1, record::Verdict::Failed, "", "the worker died"}};
  page.manifest = "{}";
  const std::string text = as_html(page);
  for (const std::string tag :
       {"table", "tbody", "tr",   "td",   "th",  "div", "p", "h2",      "h3",     "details",
        "ul",    "li",    "span", "code", "pre", "b",   "i", "summary", "script", "style"}) {
    const std::size_t opened = count(text, "<" + tag + " ") + count(text, "<" + tag + ">");
    EXPECT_EQ(opened, count(text, "</" + tag + ">")) << tag;
  }
}

TEST(Html, TakesNoNameForMarkup) {
  Header header = example_header();
  header.description = "<script>alert(1)</script> & more";
  header.conditions[0].a.name = "<b>\"x\"";
  const std::string text = as_html(page_of(summarise(header, {}), {}));
  EXPECT_THAT(text, Not(HasSubstr("<script>alert")));
  EXPECT_THAT(text, HasSubstr("&lt;script&gt;alert(1)&lt;/script&gt; &amp; more"));
  EXPECT_THAT(text, HasSubstr("&lt;b&gt;&quot;x&quot;"));
}

TEST(Html, LoadsItselfAgainOnlyWhileARunGoesOn) {
  Page page = page_of(example(), {});
  EXPECT_THAT(as_html(page), Not(HasSubstr("http-equiv=\"refresh\"")));
  page.refresh = true;
  EXPECT_THAT(as_html(page), HasSubstr("http-equiv=\"refresh\""));
}

// Names come straight from a ledger, which somebody else may have written.
TEST(Html, HasNoMarkupFromNames) {
  Summary summary = example();
  const std::string evil = "<script>alert('x')</script>\"&\x1B[2J";
  summary.header.description = evil;
  summary.header.answers = {evil};
  summary.header.remarks = {evil};
  for (Header::Condition& condition : summary.header.conditions) condition.name = condition.a.name = evil;
  for (Row& row : summary.rows) row.condition = row.a.name = evil;
  Page page = page_of(summary, {});
  page.manifest = evil;
  page.no_figures = evil;
  const std::string text = as_html(page);
  EXPECT_THAT(text, HasSubstr("&lt;script&gt;alert(&#39;x&#39;)&lt;/script&gt;&quot;&amp;\xEF\xBF\xBD[2J"));
  EXPECT_EQ(count(text, "<script>"), 1U) << "ours";
  EXPECT_EQ(count(text, "\x1B"), 0U);
}

class WriteHtml : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "report-test-XXXXXX").string();
    ASSERT_NE(::mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  void TearDown() override { fs::remove_all(folder_); }
  fs::path folder_;
};

TEST_F(WriteHtml, WritesOneFileWithTheManifest) {
  std::ofstream(folder_ / "manifest.json") << "{\"commit\": \"abc\"}";
  std::ofstream(folder_ / "report.html") << "an older one";
  EXPECT_EQ(write_html(folder_, example(), {}, false), folder_ / "report.html");
  std::ostringstream text;
  text << std::ifstream(folder_ / "report.html").rdbuf();
  EXPECT_THAT(text.str(), HasSubstr("&quot;commit&quot;: &quot;abc&quot;"));
  EXPECT_THAT(text.str(), Not(HasSubstr("an older one")));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 2)
      << "nothing left over";
}

TEST_F(WriteHtml, SaysWhichFileCannotBeWritten) {
  try {
    write_html(folder_ / "missing", example(), {}, false);
    ADD_FAILURE() << "nothing thrown";
  } catch (const std::system_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("missing/report.html: cannot be written: No such file or directory"));
  }
}

}  // namespace
}  // namespace report

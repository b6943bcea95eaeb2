#include "experiments/process/filter.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace process {
namespace {

using testing::HasSubstr;

TEST(Filter, GivesInputAndTakesOutput) {
  const Filtered found = filter({.arguments = {"tr", "a-z", "A-Z"}, .input = "one\ntwo"});
  EXPECT_TRUE(found.well) << found.problem;
  EXPECT_EQ(found.output, "ONE\nTWO");
}

TEST(Filter, KnowsNoShell) {
  const std::string word = "$(echo no) `echo no` ; echo 'no' \"$HOME\"";
  EXPECT_EQ(filter({.arguments = {"printf", "%s", word}, .input = ""}).output, word);
}

TEST(Filter, InputCanBeReadTwice) {
  const Filtered found = filter({.arguments = {"cat", "/dev/stdin", "/dev/stdin"}, .input = "again "});
  EXPECT_EQ(found.output, "again again ");
}

TEST(Filter, TakesMoreThanAPipeHolds) {
  const std::string much(std::size_t{3} << 20, 'x');
  EXPECT_EQ(filter({.arguments = {"cat"}, .input = much}).output, much);
}

TEST(Filter, LeavesOutWhatGoesToStandardError) {
  const Filtered found = filter({.arguments = {"sh", "-c", "echo out; echo error >&2"}, .input = ""});
  EXPECT_EQ(found.output, "out\n");
}

TEST(Filter, SaysHowItEnded) {
  const Filtered found = filter({.arguments = {"sh", "-c", "echo half; exit 3"}, .input = ""});
  EXPECT_FALSE(found.well);
  EXPECT_EQ(found.problem, "ended with code 3");
  EXPECT_EQ(found.output, "half\n");
}

TEST(Filter, EndsWhatTakesTooLongOrPrintsTooMuch) {
  EXPECT_EQ(filter({.arguments = {"sleep", "60"}, .input = "", .patience = std::chrono::seconds{1}}).problem,
            "took longer than 1 s");
  EXPECT_EQ(filter({.arguments = {"echo", "abcdef"}, .input = "", .longest_output = 3}).problem,
            "printed more than 3 bytes");
}

TEST(Filter, SaysThatTheProgramIsMissing) {
  try {
    filter({.arguments = {"no-such-program"}, .input = ""});
    ADD_FAILURE() << "nothing thrown";
  } catch (const StartError& error) {
    EXPECT_THAT(error.what(), HasSubstr("no-such-program"));
  }
}

}  // namespace
}  // namespace process

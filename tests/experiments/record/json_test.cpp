#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "experiments/record/json_text.h"
#include "tests/experiments/record/examples.h"

namespace record {
namespace {

using testing::HasSubstr;

TEST(Json, GivesTheSameConfigurationBack) {
  EXPECT_EQ(match_config_from_json(to_json(example_config())), example_config());
  EXPECT_EQ(match_config_from_json(to_json(MatchConfig{})), MatchConfig{});
}

TEST(Json, GivesTheSameRecordBack) {
  EXPECT_EQ(match_record_from_json(to_json(example_record())), example_record());
  EXPECT_EQ(match_record_from_json(to_json(MatchRecord{})), MatchRecord{});
}

TEST(Json, IsOneLine) {
  MatchRecord record = example_record();
  record.reason = "two\nlines";
  EXPECT_EQ(to_json(record).find('\n'), std::string::npos);
}

TEST(Json, KeepsNumbersExactly) {
  EXPECT_EQ(number(0.1), "0.1");
  EXPECT_EQ(number(1.0 / 3), "0.3333333333333333");
  EXPECT_EQ(number(std::numeric_limits<double>::infinity()), "null");
}

TEST(Json, WritesBytesThatAreNoText) {
  MatchRecord record = example_record();
  record.reason = "said \xff\xfe";
  EXPECT_THAT(match_record_from_json(to_json(record)).reason, HasSubstr("said "));
}

std::string complaint(const std::string& text) {
  try {
    match_config_from_json(text);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Json, ComplaintsNameTheField) {
  EXPECT_THAT(complaint("{"), HasSubstr("match configuration: not JSON"));
  EXPECT_THAT(complaint("[]"), HasSubstr("not a JSON object"));
  EXPECT_THAT(complaint("{}"), HasSubstr("field 'yellow' is missing"));
  std::string text = to_json(example_config());
  text.replace(text.find("\"harsh\""), 7, "5");
  EXPECT_THAT(complaint(text), HasSubstr("field 'realism' has the wrong type: 5"));
  text = to_json(example_config());
  text.replace(text.find("\"first_kickoff\":\"blue\""), 22, "\"first_kickoff\":\"red\"");
  EXPECT_THAT(complaint(text), HasSubstr("field 'first_kickoff' must be yellow or blue, not 'red'"));
}

}  // namespace
}  // namespace record

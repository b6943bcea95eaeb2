#include "sim/server/report.h"

#include <gtest/gtest.h>

using server::news;
using server::Troubles;

TEST(Report, IsSilentWhenAllIsWell) {
  Troubles now;
  now.control.messages = 100;
  EXPECT_EQ(news({}, now), "");
}

TEST(Report, TellsWhatIsNewByPortAndKind) {
  Troubles before;
  before.control.refused["UNREADABLE"] = 3;
  before.skipped = std::chrono::seconds{1};
  Troubles now = before;
  EXPECT_EQ(news(before, now), "");
  now.control.refused["UNREADABLE"] = 5;
  now.control.refused["TOO_LONG"] = 1;
  now.robots.yellow.refused["ROBOT_ABSENT"] = 2;
  EXPECT_EQ(news(before, now),
            "refused from control: 1 TOO_LONG, 2 UNREADABLE; refused from yellow: 2 ROBOT_ABSENT");
  now = before;
  now.not_sent = 7;
  now.skipped += std::chrono::milliseconds{250};
  now.speed = 20;
  EXPECT_EQ(news(before, now),
            "7 datagrams could not be sent; cannot keep up with speed 20: 0.250 s were not played");
}

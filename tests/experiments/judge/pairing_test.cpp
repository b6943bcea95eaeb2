#include "experiments/judge/pairing.h"

#include <gtest/gtest.h>

namespace judge {
namespace {

world::Time at(double seconds) { return world::Time{world::from_seconds(seconds)}; }

TrueEvent truth(double seconds, double margin, Event event = Event::Exit) {
  TrueEvent one;
  one.event = event;
  one.time = at(seconds);
  one.margin = margin;
  return one;
}

Call call(double seconds, Event event = Event::Exit) {
  Call one;
  one.event = event;
  one.time = one.reported = at(seconds);
  return one;
}

std::vector<Case> paired(const std::vector<TrueEvent>& truths, const std::vector<Call>& calls,
                         const char* rules = "ssl-2015") {
  return pair("it", truths, calls, world::rule_set(rules));
}

int count(const std::vector<Case>& cases, Result result) {
  return static_cast<int>(std::ranges::count(cases, result, &Case::result));
}

TEST(Pair, IsOneToOneAndNearestFirst) {
  const auto cases = paired({truth(1, 5)}, {call(1.2), call(0.9)});
  ASSERT_EQ(cases.size(), 2u);
  EXPECT_EQ(cases[0].result, Result::Found);
  EXPECT_EQ(cases[0].call->time, at(0.9));
  EXPECT_EQ(cases[1].result, Result::Extra);
}

TEST(Pair, EndsAtThreeTenthsOfASecond) {
  EXPECT_EQ(count(paired({truth(1, 5)}, {call(1.299)}), Result::Found), 1);
  const auto apart = paired({truth(1, 5)}, {call(1.301)});
  EXPECT_EQ(count(apart, Result::Missed), 1);
  EXPECT_EQ(count(apart, Result::Extra), 1);
}

TEST(Pair, GivesAClearEventItsCallBeforeACloseOne) {
  const auto cases = paired({truth(1.0, 0.5), truth(1.1, 5)}, {call(1.0)});
  EXPECT_EQ(count(cases, Result::Found), 1);
  for (const Case& one : cases) EXPECT_EQ(one.close(), one.result == Result::Missed);
}

TEST(Pair, ForgivesACallOfWhatNearlyHappenedOnlyWithinABand) {
  EXPECT_TRUE(paired({truth(1, -0.5)}, {call(1)}).at(0).close());
  const auto beyond = paired({truth(1, -1.5)}, {call(1)});
  ASSERT_EQ(beyond.size(), 1u);
  EXPECT_EQ(beyond[0].result, Result::Extra);
  EXPECT_EQ(beyond[0].remark, "ball left field nearly");
  EXPECT_TRUE(paired({truth(1, -1.5)}, {}).empty()) << "nothing happened and nothing was called";
}

TEST(Pair, ForgivesALateCallOfACloseEventThatLasted) {
  TrueEvent lasted = truth(1, 0.5);
  lasted.until = at(1.4);
  EXPECT_EQ(count(paired({lasted}, {call(1.6)}), Result::Found), 1);
  lasted.margin = 5;
  EXPECT_EQ(count(paired({lasted}, {call(1.6)}), Result::Found), 0) << "a clear one has its moment";
}

TEST(Pair, GivesEachRobotItsOwnCallWhenSeveralOffendTogether) {
  const auto robot = [](int number) {
    return world::RobotId{world::Team::Blue, static_cast<std::uint8_t>(number)};
  };
  TrueEvent one = truth(1, 5, Event::TooNearInStop);
  one.by = robot(1);
  one.until = at(9);
  TrueEvent other = one;
  other.by = robot(2);
  Call first = call(1.1, Event::TooNearInStop);
  first.by = robot(2);
  Call second = call(1.1, Event::TooNearInStop);
  second.by = robot(1);
  const auto cases = paired({one, other}, {first, second});
  ASSERT_EQ(cases.size(), 2u);
  for (const Case& its : cases) EXPECT_EQ(its.truth->by, its.call->by);
}

TEST(Case, IsLateWhenItHadBeenClearForLongerThanTheWindow) {
  TrueEvent lasts = truth(1, 5, Event::TooNearInStop);
  lasts.until = at(9);
  lasts.clear = at(2);
  EXPECT_FALSE(paired({lasts}, {call(2.29, Event::TooNearInStop)}).at(0).late());
  const auto late = paired({lasts}, {call(2.31, Event::TooNearInStop)});
  ASSERT_EQ(late.size(), 1u);
  EXPECT_TRUE(late[0].late());
  EXPECT_EQ(count(paired({lasts}, {call(9.4, Event::TooNearInStop)}), Result::Extra), 1) << "it was over";
}

TEST(Pair, DoesNotCountWhatCameAfterTheWhistleUnlessBothSawIt) {
  TrueEvent late_truth = truth(1, 5);
  late_truth.late = true;
  Call late_call = call(1.1);
  late_call.late = true;
  EXPECT_TRUE(paired({late_truth}, {}).empty());
  EXPECT_TRUE(paired({}, {late_call}).empty());
  EXPECT_EQ(count(paired({late_truth}, {call(0.9)}), Result::Found), 1) << "called a little early";
  EXPECT_EQ(count(paired({truth(1, 5)}, {late_call}), Result::Found), 1) << "called a little late";
}

TEST(Pair, TakesChipGoalsForGoalsWhereTheRulesDoNotKnowThem) {
  const auto ours = paired({truth(1, 5, Event::ChippedGoal)}, {call(1, Event::Goal)});
  EXPECT_EQ(count(ours, Result::Extra), 1);
  EXPECT_EQ(count(ours, Result::Missed), 1);
  const auto papers = paired({truth(1, 5, Event::ChippedGoal)}, {call(1, Event::Goal)}, "paper");
  EXPECT_EQ(count(papers, Result::Found), 1);
}

TEST(Pair, LeavesOutWhatTheRuleSetDoesNotWatch) {
  EXPECT_EQ(paired({truth(1, 5, Event::Collision)}, {}).size(), 1u);
  EXPECT_TRUE(paired({truth(1, 5, Event::Collision)}, {}, "paper").empty());
}

TEST(Case, KnowsWhetherTheTeamWasRight) {
  TrueEvent exit = truth(1, 5);
  exit.last = LastTouch{{world::Team::Blue, 1}, at(0.5)};
  Call said = call(1);
  said.last = world::Touch{{world::Team::Blue, 3}, at(0.5)};
  EXPECT_TRUE(paired({exit}, {said}).at(0).team_is_right());
  said.last->robot.team = world::Team::Yellow;
  EXPECT_FALSE(paired({exit}, {said}).at(0).team_is_right());
  said.last.reset();
  EXPECT_FALSE(paired({exit}, {said}).at(0).team_is_right());
}

TEST(Timeline, IsTheStateInWhichAFrameWouldHaveBeenJudged) {
  Timeline timeline;
  for (int n = 1; n <= 3; ++n) {
    world::GameState state;
    state.command_counter = static_cast<std::uint32_t>(n);
    timeline.add(at(n), state);
  }
  EXPECT_EQ(timeline.at(at(0.5)).command_counter, 1u);
  EXPECT_EQ(timeline.at(at(1)).command_counter, 1u);
  EXPECT_EQ(timeline.at(at(1.5)).command_counter, 2u);
  EXPECT_EQ(timeline.at(at(9)).command_counter, 3u) << "the newest, for who is ahead";
}

}  // namespace
}  // namespace judge

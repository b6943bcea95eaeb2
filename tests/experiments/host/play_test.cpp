#include "experiments/host/play.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sched.h>

#include "tests/fakes/games.h"

namespace host {
namespace {

using record::Termination;

int first_processor() {
  cpu_set_t ours;
  ::sched_getaffinity(0, sizeof ours, &ours);
  std::size_t cpu = 0;
  while (!CPU_ISSET(cpu, &ours)) ++cpu;
  return static_cast<int>(cpu);
}

TEST(Play, AShortGameReachesItsEnd) {
  const auto record = play(fakes::short_game("wander", "wander"));
  EXPECT_EQ(record.termination, Termination::Finished) << record.reason;
  EXPECT_EQ(record.at_fault, record::Party::Nobody);
  EXPECT_EQ(record.reason, "");
  EXPECT_GE(record.ticks, 2 * 10 * world::ticks_per_second);  // both halves
  EXPECT_LE(record.ticks, 2 * 90 * world::ticks_per_second);  // each half overruns by at most 60 s; set-ups
  EXPECT_THAT(record.hash, testing::MatchesRegex("[0-9a-f]{32}"));
  EXPECT_EQ(record.versions.yellow, "fake-team wander");
  ASSERT_FALSE(record.timeline.empty());
  for (std::size_t i = 1; i < record.timeline.size(); ++i) {
    EXPECT_LE(record.timeline[i - 1].time, record.timeline[i].time);
  }
  EXPECT_EQ(record.counters.at("referee_loop_defects"), 0);
  EXPECT_GT(record.costs.at("peak_memory_yellow"), 1 << 20);
}

// A design chooses the field by the name of the rule set (R-R15-16).
TEST(Play, OtherFieldsAndThePapersRulesCanBePlayedOn) {
  for (const char* rules : {"paper", "ssl-2015-field-2014", "ssl-2015-division-a", "paper-field-2014"}) {
    auto config = fakes::short_game("wander", "wander");
    config.rules = rules;
    config.half_length = 2;
    const auto record = play(config);
    EXPECT_EQ(record.termination, Termination::Finished) << rules << ": " << record.reason;
    EXPECT_EQ(record.counters.at("referee_loop_defects"), 0) << rules;
  }
}

TEST(Play, TheSameGameHasTheSameHashAndAnotherSeedAnotherOne) {
  auto config = fakes::short_game("wander", "wander");
  const auto first = play(config);
  auto second = play(config);
  ASSERT_EQ(first.termination, Termination::Finished) << first.reason;
  EXPECT_EQ(first.hash, second.hash);
  // All of it is the same but for what it cost.
  second.costs = first.costs;
  second.wall_seconds = first.wall_seconds;
  EXPECT_EQ(first, second);

  config.seed = 8;
  EXPECT_NE(play(config).hash, first.hash);
}

TEST(Play, TheHashDoesNotDependOnTheProcessorOrOnBeingMeasured) {
  const auto config = fakes::short_game("wander", "wander");
  const auto free = play(config);
  Options options;
  options.cpu = first_processor();
  Stopwatch stopwatch;
  options.stopwatch = &stopwatch;
  const auto bound = play(config, options);
  EXPECT_EQ(free.hash, bound.hash);
  EXPECT_EQ(stopwatch.ticks(), static_cast<std::size_t>(bound.ticks));
  EXPECT_GT(stopwatch.mean(Part::Physics), 0);
  EXPECT_EQ(stopwatch.messages, 4 * (bound.ticks - 1));  // nothing is sent after the last tick
}

TEST(Play, ASlowTeamPlaysTheSameGame) {
  auto config = fakes::short_game("good", "good");
  config.half_length = 0.5;
  const auto fast = play(config);
  config.teams.blue.command = fakes::fake_team("slow");
  EXPECT_EQ(play(config).hash, fast.hash);
}

TEST(Play, HandicapsChangeTheGame) {
  auto config = fakes::short_game("wander", "wander");
  const auto full = play(config);
  config.teams.blue.speed_factor = 0.5;
  const auto slow = play(config);
  EXPECT_EQ(slow.termination, Termination::Finished) << slow.reason;
  EXPECT_NE(slow.hash, full.hash);
  config.teams.blue.robots = {0, 3, 15};
  const auto few = play(config);
  EXPECT_EQ(few.termination, Termination::Finished) << few.reason;
  EXPECT_NE(few.hash, slow.hash);
}

TEST(Play, ReportsCallsAndSecondsAsTheyHappen) {
  Options options;
  std::vector<record::CallEntry> calls;
  int seconds = 0;
  options.on_call = [&](const record::CallEntry& entry, const world::PerTeam<int>&) {
    calls.push_back(entry);
  };
  options.on_second = [&](world::Time, const world::PerTeam<int>&) { ++seconds; };
  const auto record = play(fakes::short_game("good", "good"), options);
  EXPECT_EQ(calls, record.timeline);
  EXPECT_NEAR(seconds, static_cast<double>(record.ticks) / world::ticks_per_second, 1);
}

TEST(Play, RefusesAnImpossibleGameBeforeAnythingStarts) {
  const auto reason = [](const auto& change) -> std::string {
    auto config = fakes::short_game("good", "good");
    change(config);
    try {
      check(config);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "accepted";
  };
  using record::MatchConfig;
  using testing::HasSubstr;
  EXPECT_EQ(reason([](MatchConfig&) {}), "accepted");
  EXPECT_THAT(reason([](MatchConfig& c) { c.rules = "ssl-1999"; }), HasSubstr("ssl-1999"));
  EXPECT_THAT(reason([](MatchConfig& c) { c.realism.preset = "perfect"; }), HasSubstr("perfect"));
  EXPECT_THAT(reason([](MatchConfig& c) { c.realism.changes["vision.ball_sigma"] = -1; }),
              HasSubstr("vision.ball_sigma = -1"));
  EXPECT_THAT(reason([](MatchConfig& c) { c.half_length = 0; }), HasSubstr("half_length 0"));
  EXPECT_THAT(reason([](MatchConfig& c) { c.teams.blue.robots = {}; }),
              HasSubstr("blue (Fake B): robots lists 0 robots, 1 to 6"));
  EXPECT_THAT(reason([](MatchConfig& c) { c.teams.blue.robots = {0, 1, 2, 3, 4, 5, 6}; }),
              HasSubstr("lists 7 robots"));
  EXPECT_THAT(reason([](MatchConfig& c) { c.teams.yellow.robots = {1, 16}; }), HasSubstr("16"));
  EXPECT_THAT(reason([](MatchConfig& c) { c.teams.yellow.robots = {1, 1}; }), HasSubstr("1"));
  EXPECT_THAT(reason([](MatchConfig& c) { c.teams.yellow.speed_factor = 0; }),
              HasSubstr("yellow (Fake Y): "));
  EXPECT_THAT(reason([](MatchConfig& c) { c.teams.yellow.command = {}; }),
              HasSubstr("yellow (Fake Y): command is empty"));
  Options options;
  options.cpu = 100000;
  EXPECT_THROW(play(fakes::short_game("good", "good"), options), std::invalid_argument);
}

}  // namespace
}  // namespace host

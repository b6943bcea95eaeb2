#include "experiments/report/health.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/stats/random.h"
#include "tests/experiments/report/examples.h"

namespace report {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;

TEST(Health, CountsFaultsByTeamAndKind) {
  std::vector<record::Attempt> games = {game("equal", 0, 0, 1, 0), forfeit_by_a(game("equal", 0, 1, 0, 0)),
                                        spoilt(game("equal", 1, 0, 0, 0)), game("equal", 1, 1, 2, 0)};
  games[1].record.reason = "ended by signal 11";
  games[3].record.hash = games[0].record.hash;
  const Health health = health_of(games);
  EXPECT_EQ(health.attempts, 4);
  EXPECT_EQ(health.finished, 2);
  EXPECT_EQ(health.forfeits, 1);
  EXPECT_EQ(health.voids, 1);
  EXPECT_EQ(health.distinct, 1) << "a copy";
  EXPECT_THAT(health.faults, ElementsAre(Pair("A crashed", 1), Pair("harness-fault", 1)));
  EXPECT_THAT(health.reasons, testing::Contains(HasSubstr("equal-0000-1: A crashed, ended by signal 11")));
}

TEST(Health, NamesATeamThatStoodStill) {
  std::vector<record::Attempt> games = {forfeit_by_a(game("equal", 0, 0, 0, 0))};
  games[0].record.termination = record::Termination::StoodStill;
  games[0].record.reason = "blue (A) never told a robot to move";
  const Health health = health_of(games);
  EXPECT_EQ(health.forfeits, 1);
  EXPECT_THAT(health.faults, ElementsAre(Pair("A stood-still", 1)));
  EXPECT_THAT(health.reasons,
              ElementsAre("equal-0000-0: A stood-still, blue (A) never told a robot to move"));
}

/// Games of which A wins, draws and loses about a third each, mixed by chance, on two workers.
std::vector<record::Attempt> even_games() {
  stats::Random random(1);
  std::vector<record::Attempt> games;
  for (int pair = 0; pair < 60; ++pair) {
    for (int leg = 0; leg < 2; ++leg) {
      const std::uint64_t kind = random.below(3);
      games.push_back(game("equal", pair, leg, kind == 0 ? 1 : 0, kind == 2 ? 1 : 0));
      games.back().worker = pair % 2;
      games.back().started = "2026-11-21T20:15:00Z";
    }
  }
  return games;
}

const Health::Check& check(const Health& health, const std::string& what) {
  for (const Health::Check& one : health.checks) {
    if (one.what == what) return one;
  }
  throw std::logic_error("no check " + what);
}

TEST(Health, FindsNothingWhereNothingIs) {
  const Health health = health_of(even_games());
  EXPECT_GT(check(health, "worker").p_holm, suspicious);
  EXPECT_EQ(check(health, "hour").text(), "too few games to say") << "one hour only";
}

TEST(Health, FindsAWorkerOnWhichAAlwaysWins) {
  std::vector<record::Attempt> games = even_games();
  for (record::Attempt& one : games) {
    if (one.worker == 1) one.record.goals[one.a_colour] = 9;
  }
  const Health health = health_of(games);
  EXPECT_LT(check(health, "worker").p_holm, suspicious);
  EXPECT_THAT(check(health, "worker").text(), HasSubstr("SUSPICIOUS, most of all worker"));
}

TEST(Health, FindsADriftInTheOrderOfTheSchedule) {
  std::vector<record::Attempt> games = even_games();
  for (record::Attempt& one : games) {
    if (one.key.pair >= 30) one.record.goals[one.a_colour] += 5;
  }
  EXPECT_LT(health_of(games).runs.p, suspicious);
  EXPECT_GT(health_of(even_games()).runs.p, suspicious);
}

// Conditions with different results one after the other are no pattern in time.
TEST(Health, TakesTheConditionsApartBeforeItLooksForADrift) {
  std::vector<record::Attempt> games = even_games();
  std::vector<record::Attempt> other = even_games();
  for (record::Attempt& one : other) {
    one.key.condition = "hindered";
    one.record.goals[one.a_colour] += 20;
  }
  games.insert(games.end(), other.begin(), other.end());
  EXPECT_GT(health_of(games).runs.p, suspicious);
}

TEST(Health, BearsNothing) {
  const Health health = health_of({});
  EXPECT_EQ(health.attempts, 0);
  EXPECT_EQ(health.checks.size(), 5U);
}

}  // namespace
}  // namespace report

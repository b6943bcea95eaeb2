#include "experiments/runner/plan.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "experiments/record/ledger.h"
#include "tests/experiments/runner/support.h"

namespace runner {
namespace {

record::Attempt finished(const Job& job) {
  record::Attempt attempt = attempt_of(job);
  attempt.record.termination = record::Termination::Finished;
  attempt.record.at_fault = record::Party::Nobody;
  return attempt;
}

/// A record is a harness fault until it says otherwise.
record::Attempt spoilt(const Job& job) { return attempt_of(job); }

std::string name_of(const std::optional<Job>& job) {
  return job ? record::game_id(job->game.key) + "/" + std::to_string(job->attempt) : "none";
}

TEST(Plan, OffersEveryGameOnceInTheSchedulesOrder) {
  Plan plan(small_design(1), {});
  EXPECT_EQ(plan.total(), 4U);
  EXPECT_EQ(name_of(plan.next()), "equal-0000-0/1");
  EXPECT_EQ(name_of(plan.next()), "equal-0000-1/1");
  EXPECT_EQ(name_of(plan.next()), "slow-0000-0/1");
  EXPECT_EQ(name_of(plan.next()), "slow-0000-1/1");
  EXPECT_EQ(name_of(plan.next()), "none");
}

TEST(Plan, OffersWhatTheLedgerLacks) {
  const schedule::Design design = small_design(1);
  Plan first(design, {});
  const std::vector<record::Attempt> ledger = {finished(*first.next())};
  Plan plan(design, ledger);
  EXPECT_EQ(plan.resolved(), 1U);
  EXPECT_EQ(name_of(plan.next()), "equal-0000-1/1");
}

TEST(Plan, PlaysBothLegsOfAPairWithAVoidGameAgainAtTheEnd) {
  Plan plan(small_design(1), {});
  const Job first = *plan.next();
  const Job second = *plan.next();
  plan.add(finished(first));
  plan.add(spoilt(second));
  EXPECT_EQ(plan.resolved(), 0U);
  EXPECT_EQ(name_of(plan.next()), "slow-0000-0/1");
  EXPECT_EQ(name_of(plan.next()), "slow-0000-1/1");
  EXPECT_EQ(name_of(plan.next()), "equal-0000-0/2");
  EXPECT_EQ(name_of(plan.next()), "equal-0000-1/2");
}

TEST(Plan, DoesNotStartTheSecondLegOfAPairThatIsVoidAlready) {
  Plan plan(small_design(1), {});
  plan.add(spoilt(*plan.next()));
  EXPECT_EQ(name_of(plan.next()), "slow-0000-0/1");
}

TEST(Plan, IgnoresALateResultOfAnAttemptThatWasGivenUp) {
  Plan plan(small_design(1), {});
  const Job first = *plan.next();
  const Job second = *plan.next();
  plan.add(spoilt(first));
  plan.add(finished(second));
  EXPECT_EQ(plan.resolved(), 0U);
}

TEST(Plan, GivesAPairUpAfterThreeAttempts) {
  schedule::Design design = small_design(1);
  design.conditions.pop_back();
  Plan plan(design, {});
  for (int attempt = 1; attempt <= 3; ++attempt) {
    ASSERT_EQ(name_of(plan.next()), "equal-0000-0/" + std::to_string(attempt));
    Job job{schedule::game(design, 0), attempt};
    plan.add(spoilt(job));
  }
  EXPECT_EQ(name_of(plan.next()), "none");
  EXPECT_EQ(plan.given_up_pairs(), 1U);
  EXPECT_EQ(plan.resolved(), 2U);
}

TEST(Plan, ContinuesWithTheSameAttemptsAsWithoutABreak) {
  const schedule::Design design = small_design(1);
  Plan plan(design, {});
  std::vector<record::Attempt> ledger;
  ledger.push_back(finished(*plan.next()));
  ledger.push_back(spoilt(*plan.next()));
  for (const record::Attempt& attempt : ledger) plan.add(attempt);
  Plan continued(design, ledger);
  for (int i = 0; i < 5; ++i) EXPECT_EQ(name_of(continued.next()), name_of(plan.next()));
}

TEST(Plan, NeedsNoGamesBehindTheEndOfACondition) {
  Plan plan(small_design(3), {});
  plan.stop("equal", 1);
  EXPECT_EQ(plan.total(), 8U);
  std::vector<std::string> names;
  while (const auto job = plan.next()) names.push_back(name_of(job));
  EXPECT_EQ(names.size(), 8U);
  EXPECT_EQ(std::count(names.begin(), names.end(), "equal-0001-0/1"), 0);
  EXPECT_EQ(std::count(names.begin(), names.end(), "slow-0002-1/1"), 1);
}

TEST(Plan, DoesNotPlayAVoidPairAgainThatIsNotNeededAnyMore) {
  Plan plan(small_design(2), {});
  std::vector<Job> jobs;
  while (const auto job = plan.next()) jobs.push_back(*job);
  plan.stop("equal", 1);
  plan.add(spoilt(jobs[4]));  // equal-0001-0
  EXPECT_EQ(name_of(plan.next()), "none");
  for (const Job& job : jobs) {
    if (job.game.key != record::GameKey{"equal", 1, 0}) plan.add(finished(job));
  }
  EXPECT_EQ(plan.resolved(), plan.total());
}

TEST(Plan, RefusesGamesOfAnotherDesign) {
  const schedule::Design design = small_design(1);
  record::Attempt stranger = finished({schedule::game(design, 0), 1});
  stranger.key.pair = 1;
  const std::vector<record::Attempt> ledger = {stranger};
  EXPECT_THROW(Plan(design, ledger), record::StorageError);
}

}  // namespace
}  // namespace runner

#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "experiments/record/attempt.h"
#include "experiments/record/audit.h"
#include "experiments/stats/homogeneity.h"

namespace report {

/// What tells whether the numbers of a run can be believed.
struct Health {
  std::int64_t attempts = 0;
  std::int64_t finished = 0;  ///< played to their end
  std::int64_t forfeits = 0;
  std::int64_t voids = 0;
  std::int64_t distinct = 0;          ///< hashes among the finished games of the same condition
  std::map<std::string, int> faults;  ///< "A crashed", "harness-fault": how often
  std::vector<std::string> reasons;   ///< of the last faults, at most ten, each with its game

  /// A's wins, draws and losses, by something that should not matter.
  struct Check {
    std::string what;  ///< "worker", "hour", "colour of A", "end A defends first", "first kickoff"
    stats::Homogeneity result;
    double p_holm = 1;         ///< adjusted for the number of checks that could be made
    std::string text() const;  ///< the finding in one phrase
  };
  std::vector<Check> checks;
  stats::RunsTest runs;  ///< A's mean goal difference in each round of the schedule, in their order
};

inline constexpr double suspicious = 0.01;  ///< ours: five checks over a hundred runs cry wolf once

/// How many audits came to each verdict, in the order of the verdicts; those that never
/// occurred are left out.
struct AuditLine {
  record::Verdict verdict{};
  std::size_t count = 0;
  std::string games;  ///< the first five, when something was wrong with them
  /// "the same hash", "another hash: a team is not deterministic", ...
  const char* meaning() const;
};
std::vector<AuditLine> audit_lines(std::span<const record::Audit> audits);

Health health_of(std::span<const record::Attempt> attempts);

}  // namespace report

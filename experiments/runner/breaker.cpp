#include "experiments/runner/breaker.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "experiments/record/waited_for.h"

namespace runner {
namespace {

constexpr int least_waits = 3;  // for one team, before they are worth a word (ours)

/// A tenth of the games may have to be played again, and ten of a small experiment (ours).
int retry_budget(std::size_t games) { return static_cast<int>(std::max(std::size_t{10}, games / 10)); }

}  // namespace

Breaker::Breaker(const schedule::Limits& limits, std::size_t games)
    : limits_(limits), most_voids_(std::max(retry_budget(games), limits.faults_in_a_row)) {}

void Breaker::add(const record::Attempt& attempt) {
  if (reason_) return;
  const bool is_void = record::outcome(attempt.record) == record::Outcome::Void;
  ++attempts_;
  voids_ += is_void ? 1 : 0;
  voids_in_a_row_ = is_void ? voids_in_a_row_ + 1 : 0;
  if (is_void) {
    const auto& costs = attempt.record.costs;
    waited_for_a_ += costs.contains(record::waited_for(attempt.a_colour)) ? 1 : 0;
    waited_for_b_ += costs.contains(record::waited_for(world::opponent(attempt.a_colour))) ? 1 : 0;
  } else {
    const record::Party at_fault = attempt.record.at_fault;
    forfeits_a_ = at_fault == record::party(attempt.a_colour) ? forfeits_a_ + 1 : 0;
    forfeits_b_ = at_fault == record::party(world::opponent(attempt.a_colour)) ? forfeits_b_ + 1 : 0;
  }

  std::ostringstream why;
  if (voids_in_a_row_ >= limits_.faults_in_a_row) {
    why << voids_in_a_row_ << " games in a row were void";
  } else if (attempts_ >= least_attempts && voids_ > limits_.fault_share * attempts_) {
    why << voids_ << " of " << attempts_ << " games were void, at most "
        << std::lround(100 * limits_.fault_share) << " % may be";
  } else if (voids_ > most_voids_) {
    why << voids_ << " games were void, " << most_voids_ << " are played again";
  } else if (std::max(forfeits_a_, forfeits_b_) >= forfeits_in_a_row) {
    why << "team " << (forfeits_a_ > forfeits_b_ ? "A" : "B") << " forfeited " << forfeits_in_a_row
        << " games in a row";
  } else {
    return;
  }
  why << " (the last: " << attempt.record.reason << ")";
  reason_ = why.str();
}

std::string Breaker::waits() const {
  const int most = std::max(waited_for_a_, waited_for_b_);
  if (most < least_waits) return "";
  const std::string team = waited_for_a_ == waited_for_b_ ? "each team"
                           : waited_for_a_ == most        ? "team A"
                                                          : "team B";
  return "in " + std::to_string(most) + " of " + std::to_string(voids_) + " void games the host waited for " +
         team;
}

}  // namespace runner

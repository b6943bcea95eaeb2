#pragma once

#include <deque>
#include <optional>
#include <span>
#include <string>

#include "experiments/record/audit.h"
#include "experiments/runner/plan.h"
#include "experiments/runner/result_folder.h"

namespace runner {

/// The recorded replies of both teams in an attempt's folder; nothing when there are none.
std::optional<std::filesystem::path> kept_replies(const std::filesystem::path& folder);

/// A game of the ledger on its way through an audit: first with live teams, and when its hash differs, once
/// more from the recorded replies without teams, to tell a team from the simulator.
struct AuditStep {
  record::Attempt original;
  bool from_replies = false;
  std::string live_hash;  ///< of the first step
};

/// What is played for a step.
Job audit_job(const schedule::Design& design, const AuditStep& step, const ResultFolder& folder);

/// Games waiting for their audit.
class Audits {
 public:
  /// Whether a game of the ledger is one to be audited.
  static bool wanted(const record::Attempt& attempt, const std::string& experiment_hash, double share);

  void add(const record::Attempt& attempt) { waiting_.push_back({attempt, false, {}}); }

  /// A step that could not be begun is the next again.
  void put_back(AuditStep step) { waiting_.push_front(std::move(step)); }

  bool empty() const { return waiting_.empty(); }
  /// The next to play.
  std::optional<AuditStep> next();

  /// Takes in how a step ended.
  /// @param replies  whether there are recorded replies to go on with
  /// @return  the audit, when it is complete
  std::optional<record::Audit> ended(const AuditStep& step, const record::MatchRecord& again, bool replies);

 private:
  std::deque<AuditStep> waiting_;
};

/// "12 games audited: all the same", or what differs, and what follows from it.
std::string audit_summary(std::span<const record::Audit> audits);

}  // namespace runner

#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "experiments/record/ledger.h"
#include "experiments/runner/audit.h"
#include "experiments/runner/crew.h"
#include "experiments/runner/ledger_writer.h"

namespace runner {

/// Plays games of the ledger again with a crew and writes the verdicts into the ledger.
class Auditor {
 public:
  /// Audits that an earlier run missed are made up.
  ///
  /// @param ledger  for the audits of earlier runs
  /// @param share   of the games that are audited
  /// @param before  what the ledger holds already
  Auditor(const schedule::Design& design, const ResultFolder& folder, const record::Ledger& ledger,
          LedgerWriter& writer, double share, std::span<const record::Attempt> before, std::size_t places);

  /// A game that has just been written into the ledger.
  void add(const record::Attempt& attempt);

  bool idle() const { return waiting_.empty(); }  ///< there is none to start
  /// Starts the next audit in a free place; false when there is none to make.
  /// @throws what the start threw, when the machine lacks what it needs: the audit is the next again
  bool start(Crew& crew, const std::string& date);

  /// An audit's game has ended; `cut_short`: with the run, so it will be made up.
  void ended(const Crew::Ended& ended, bool cut_short);

  std::span<const record::Audit> done() const { return done_; }
  std::size_t differing() const;  ///< of those, games that went differently

 private:
  void take(const AuditStep& step, const record::MatchRecord& record);

  const schedule::Design& design_;
  const ResultFolder& folder_;
  LedgerWriter& writer_;
  std::string experiment_;  ///< its hash
  double share_;
  Audits waiting_;
  std::vector<std::optional<AuditStep>> steps_;  ///< by place: what is being audited there
  std::vector<record::Audit> done_;
};

}  // namespace runner

#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "experiments/runner/evidence.h"
#include "experiments/runner/ledger_writer.h"

namespace runner {

/// Writes games into the ledger, and the files that are kept of them.
///
/// The ledger is told before files are thrown away and after they are kept, so that a run
/// may be killed in between.
class Archive {
 public:
  /// @param limit   [bytes] of kept files
  /// @param before  what the ledger holds already
  Archive(const ResultFolder& folder, LedgerWriter& writer, std::int64_t limit,
          std::span<const record::Attempt> before)
      : folder_(folder), writer_(writer), evidence_(folder, limit, before) {}

  /// Removes what is too much to be kept of an attempt that has just ended, and says so in its reason, if it has
  /// one.
  ///
  /// @return  what was removed; empty: nothing
  std::string cut_down(record::Attempt& attempt, bool sampled) const;

  /// Writes an attempt that has just ended.
  ///
  /// @return  whether older files had to go for its own
  bool add(const record::Attempt& attempt, bool sampled);

  std::int64_t size() const { return evidence_.size(); }  ///< [bytes] of kept files

 private:
  const ResultFolder& folder_;
  LedgerWriter& writer_;
  Evidence evidence_;
};

}  // namespace runner

#include "experiments/runner/auditor.h"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <utility>

#include "experiments/runner/shortage.h"

namespace runner {

Auditor::Auditor(const schedule::Design& design, const ResultFolder& folder, const record::Ledger& ledger,
                 LedgerWriter& writer, double share, std::span<const record::Attempt> before,
                 std::size_t places)
    : design_(design),
      folder_(folder),
      writer_(writer),
      experiment_(ledger.experiment().hash),
      share_(share),
      steps_(places),
      done_(ledger.audits()) {
  std::set<std::pair<record::GameKey, int>> known;
  for (const record::Audit& audit : done_) known.insert({audit.key, audit.attempt});
  for (const record::Attempt& attempt : before) {
    if (!known.contains({attempt.key, attempt.attempt})) add(attempt);
  }
}

void Auditor::add(const record::Attempt& attempt) {
  if (Audits::wanted(attempt, experiment_, share_)) waiting_.add(attempt);
}

bool Auditor::start(Crew& crew, const std::string& date) {
  std::optional<AuditStep> step = waiting_.next();
  if (!step) return false;
  const std::string id = record::game_id(step->original.key);
  folder_.check_links(folder_.audit(id));
  try {
    const std::size_t slot =
        crew.start(Purpose::Audit, audit_job(design_, *step, folder_), folder_.audit(id), date);
    steps_[slot] = std::move(step);
  } catch (const std::runtime_error& error) {
    if (is_shortage(error)) {
      waiting_.put_back(*std::move(step));
      throw;
    }
    take(*step, never_started(error));
  }
  return true;
}

void Auditor::ended(const Crew::Ended& ended, bool cut_short) {
  const AuditStep step = *std::exchange(steps_[ended.slot], std::nullopt);
  if (cut_short) return;
  folder_.forget_audit(record::game_id(step.original.key));
  take(step, ended.attempt.record);
}

void Auditor::take(const AuditStep& step, const record::MatchRecord& record) {
  const std::string id = record::game_id(step.original.key);
  const bool replies = kept_replies(folder_.game(id, step.original.attempt)).has_value();
  if (const auto audit = waiting_.ended(step, record, replies)) {
    writer_.write([audit = *audit](record::Ledger& ledger) { ledger.add(audit); });
    done_.push_back(*audit);
  }
}

std::size_t Auditor::differing() const {
  return static_cast<std::size_t>(std::count_if(done_.begin(), done_.end(), [](const record::Audit& audit) {
    return audit.verdict != record::Verdict::Same && audit.verdict != record::Verdict::Failed;
  }));
}

}  // namespace runner

#include "experiments/runner/audit.h"

#include <algorithm>

#include "experiments/runner/evidence.h"

namespace runner {

namespace fs = std::filesystem;

std::optional<fs::path> kept_replies(const fs::path& folder) {
  for (const char* name : {"game.replies", "game.replies.gz"}) {
    if (fs::exists(folder / name)) return folder / name;
  }
  return std::nullopt;
}

Job audit_job(const schedule::Design& design, const AuditStep& step, const ResultFolder& folder) {
  Job job{schedule::find_game(design, record::game_id(step.original.key)), step.original.attempt};
  if (step.from_replies) {
    const auto replies = kept_replies(folder.game(record::game_id(step.original.key), step.original.attempt));
    if (replies) job.game.config.continuation = record::Continuation{*replies, std::nullopt};
  }
  return job;
}

bool Audits::wanted(const record::Attempt& attempt, const std::string& experiment_hash, double share) {
  return attempt.record.termination == record::Termination::Finished &&
         attempt.record.at_fault == record::Party::Nobody &&
         sampling_number(experiment_hash, attempt.key) < share;
}

std::optional<AuditStep> Audits::next() {
  if (waiting_.empty()) return std::nullopt;
  AuditStep step = std::move(waiting_.front());
  waiting_.pop_front();
  return step;
}

std::optional<record::Audit> Audits::ended(const AuditStep& step, const record::MatchRecord& again,
                                           bool replies) {
  record::Audit audit;
  audit.key = step.original.key;
  audit.attempt = step.original.attempt;
  const bool finished = again.termination == record::Termination::Finished;
  const bool same = finished && again.hash == step.original.record.hash;
  if (step.from_replies) {
    audit.hash = step.live_hash;
    audit.verdict = same ? record::Verdict::TeamDiffers : record::Verdict::SimulatorDiffers;
    if (!finished) audit.reason = again.reason;
    return audit;
  }
  audit.hash = again.hash;
  if (same) {
    audit.verdict = record::Verdict::Same;
  } else if (again.at_fault == record::Party::Harness) {
    audit.verdict = record::Verdict::Failed;
    audit.reason = again.reason;
  } else if (replies) {
    waiting_.push_front({step.original, true, again.hash});
    return std::nullopt;
  } else {
    audit.verdict = record::Verdict::TeamsOrUsDiffer;
  }
  return audit;
}

std::string audit_summary(std::span<const record::Audit> audits) {
  const auto with = [&](record::Verdict verdict) {
    std::string first;
    std::size_t count = 0;
    for (const record::Audit& audit : audits) {
      if (audit.verdict != verdict) continue;
      if (count++ == 0) first = record::game_id(audit.key);
    }
    return std::pair{count, first};
  };
  std::string text = std::to_string(audits.size()) + (audits.size() == 1 ? " game" : " games") +
                     " played again to compare hashes: ";
  const auto [same, ignored] = with(record::Verdict::Same);
  if (same == audits.size()) return text + "the same";
  text += std::to_string(same) + " the same";
  const auto say = [&](record::Verdict verdict, const char* meaning) {
    const auto [count, first] = with(verdict);
    if (count > 0) text += "; " + std::to_string(count) + " " + meaning + ", as " + first;
  };
  say(record::Verdict::TeamDiffers, "not, by a team that is not deterministic");
  say(record::Verdict::SimulatorDiffers, "not, by the simulator: A MISTAKE OF MATCHDAY, please report it");
  say(record::Verdict::TeamsOrUsDiffer, "not, by a team or the simulator");
  say(record::Verdict::Failed, "could not be played");
  return text;
}

}  // namespace runner

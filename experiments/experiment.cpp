#include "experiments/experiment.h"

#include <algorithm>
#include <stdexcept>

#include "experiments/record/ledger.h"
#include "experiments/runner/audit.h"
#include "experiments/stopping/wording.h"

namespace commands {

Experiment read_experiment(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "ledger.sqlite";
  const record::Ledger ledger = record::Ledger::read(file);
  const record::Experiment stored = ledger.experiment();
  try {
    return {schedule::parse_design(stored.design, file.string() + " (its design)"), stored.hash,
            ledger.attempts(record::Detail::WithoutTimeline), ledger.audits()};
  } catch (const std::invalid_argument& error) {
    throw record::StorageError(
        error.what());  // it was valid when it was written: damaged, or of another version
  }
}

report::Summary summary(const Experiment& experiment) {
  const schedule::Design& design = experiment.design;
  report::Header header;
  header.design = design.name;
  header.description = design.description;
  header.rules = design.rules;
  header.half_length = design.half_length;
  header.realism = record::text(design.realism);
  header.seed = design.seed;
  header.pairs = design.pairs;
  header.forfeit_goals = design.forfeit_goals;
  header.experiment = experiment.hash;
  for (const schedule::Condition& condition : design.conditions) {
    report::Header::Condition one{condition.name, condition.a, condition.b, record::text(condition.realism)};
    one.sweep = condition.sweep;
    one.values = condition.values;
    if (condition.panel) {
      one.panel = {condition.panel->base, condition.panel->opponent, condition.panel->arm};
    }
    header.conditions.push_back(std::move(one));
  }
  if (design.stopping.rule == schedule::StopRule::Sequential) {
    for (const stopping::Standing& one : stopping::standings(design, experiment.attempts)) {
      if (one.question.panel) continue;  // its own sentence says it
      header.conditions[one.question.terms.front().condition].answer = stopping::verdict(one);
    }
  }
  if (design.stopping.rule != schedule::StopRule::Fixed) header.stopping = stopping::rule(design);
  header.answers = stopping::sentences(design, experiment.attempts);
  if (!experiment.audits.empty()) header.remarks.push_back(runner::audit_summary(experiment.audits));
  header.audits = experiment.audits;
  return report::summarise(std::move(header), stopping::counted(design, experiment.attempts));
}

bool goes_on(const Experiment& experiment, const report::Summary& summary) {
  if (experiment.design.stopping.rule != schedule::StopRule::Fixed) {
    const auto all = stopping::standings(experiment.design, experiment.attempts);
    return !std::all_of(all.begin(), all.end(), [](const stopping::Standing& one) { return one.decided(); });
  }
  std::int64_t given_up = 0;
  for (const report::Row& row : summary.rows) given_up += 2 * row.given_up_pairs;
  return summary.games + given_up < summary.planned;
}

}  // namespace commands

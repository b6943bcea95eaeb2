#include "experiments/experiment.h"

#include <stdexcept>

#include "experiments/record/ledger.h"
#include "experiments/stopping/wording.h"

namespace commands {

Experiment read_experiment(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "ledger.sqlite";
  const record::Ledger ledger = record::Ledger::read(file);
  const record::Experiment stored = ledger.experiment();
  try {
    return {schedule::parse_design(stored.design, file.string() + " (its design)"), stored.hash,
            ledger.attempts()};
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
    header.conditions.push_back({condition.name, condition.a, condition.b, record::text(condition.realism)});
  }
  return report::summarise(std::move(header), stopping::counted(design, experiment.attempts));
}

std::string conclusion(const Experiment& experiment) {
  std::string text;
  for (const std::string& sentence : stopping::sentences(experiment.design, experiment.attempts)) {
    text += (text.empty() ? "\n" : "") + sentence + "\n";
  }
  return text;
}

}  // namespace commands

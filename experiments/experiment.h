#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/record/attempt.h"
#include "experiments/report/summary.h"
#include "experiments/schedule/design.h"

namespace commands {

/// What a result folder holds.
struct Experiment {
  schedule::Design design;
  std::string hash;
  std::vector<record::Attempt> attempts;
};

/// @throws record::StorageError when there is no usable ledger in the folder
Experiment read_experiment(const std::filesystem::path& folder);

/// Of the games that count: where a stopping rule ended the games of a condition, those up to there.
report::Summary summary(const Experiment& experiment);

/// What the stopping rule of the design says of its questions, a line each; empty for a fixed number of
/// games.
std::string conclusion(const Experiment& experiment);

}  // namespace commands

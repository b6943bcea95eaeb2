#pragma once

#include "experiments/schedule/limits.h"
#include "experiments/schedule/stopping.h"
#include "experiments/schedule/toml_reader.h"

// The parts of a design that say how long it goes on, not what is played.
namespace schedule {

/// [stopping], or the defaults.
/// @param pairs  of the design: the most a run may take
/// @throws std::invalid_argument as parse_design
Stopping read_stopping(TomlTable& root, int pairs);

/// [limits], or the defaults.
/// @throws std::invalid_argument as parse_design
Limits read_limits(TomlTable& root);

}  // namespace schedule

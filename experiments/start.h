#pragma once

#include <filesystem>
#include <iosfwd>

#include "experiments/schedule/design.h"

namespace commands {

/// A design file, read and checked as far as can be without building or playing anything: its values, its
/// games, and that the programs of teams that need no building exist.
///
/// @throws std::invalid_argument in one sentence
schedule::Design checked_design(const std::filesystem::path& file);

/// Where its results go if the user does not say: results/<name>.
std::filesystem::path usual_folder(const schedule::Design& design);

}  // namespace commands

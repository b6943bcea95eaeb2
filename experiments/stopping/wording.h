#pragma once

#include <string>
#include <vector>

#include "experiments/stopping/watch.h"

namespace stopping {

/// The rule of a design in one line: metric, hypotheses and sizes, or the number or precision; from A's view.
std::string rule(const schedule::Design& design);

/// Where a question stands, in one line that names who is compared with whom; an estimate after a sequential
/// stop is the corrected one and says so.
std::string sentence(const Standing& standing, const schedule::Design& design);

/// The outcome of a sequential test as the verdict over a table, from A's view.
std::string verdict(const Standing& standing);

/// The sentences of all questions; none for a fixed number of games, where the table says all.
std::vector<std::string> sentences(const schedule::Design& design, std::span<const record::Attempt> attempts);

}  // namespace stopping

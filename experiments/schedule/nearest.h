#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace schedule {

/// "; did you mean NAME?" with the name that is most like `word`, or nothing when none is like it.
///
/// Like is an edit distance (insert, remove, exchange one letter, or two neighbours with each other) of at
/// most a third of the word, at least one (ours: finds `speed_facter` and `sed`, and no name for noise).
std::string did_you_mean(std::string_view word, const std::vector<std::string>& names);

}  // namespace schedule

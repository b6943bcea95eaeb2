#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace schedule {

/// The words of a command line, split as a shell would: blanks separate, quotes and backslashes protect.
///
/// Nothing is expanded: no variables, no `*`, no `~`.
///
/// @throws std::invalid_argument when a quote is not closed or there is no word at all
std::vector<std::string> split_command(std::string_view line);

}  // namespace schedule

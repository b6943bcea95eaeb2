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

/// What a team is called if nobody says: the file name of its program, or of the script when an interpreter
/// runs it ("python3 my_team.py" is my_team.py).
///
/// @pre command is not empty
std::string usual_name(const std::vector<std::string>& command);

/// Words as one line that a shell reads back as these words, whatever is in them.
std::string shell_line(const std::vector<std::string>& words);

}  // namespace schedule

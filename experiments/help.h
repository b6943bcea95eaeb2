#pragma once

#include <string>

// What stands below the flags in `--help`.
namespace commands {

std::string footer();                               ///< of matchday itself: exit codes
std::string footer_of(const std::string& command);  ///< of one of its commands

}  // namespace commands

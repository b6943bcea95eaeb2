#pragma once

#include <string>

namespace fakes {

/// The folder of the programs of this build: `matchday`, the teams, the fakes. A function, since the tests
/// of one build may be linked with another one's libraries (`TESTS_OF`) and then run that one's programs.
std::string bin_dir();

}  // namespace fakes

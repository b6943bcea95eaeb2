#include "tests/fakes/programs.h"

namespace fakes {

std::string bin_dir() { return BIN_DIR; }

}  // namespace fakes

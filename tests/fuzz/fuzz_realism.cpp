#include <stdexcept>

#include "sim/server/realism_file.h"
#include "tests/fuzz/support.h"
#include "tests/fuzz/target.h"

bool fuzz::realism(std::string_view bytes) {
  try {
    server::parse_realism(std::string(bytes), "fuzzed.toml");
    return true;
  } catch (const std::invalid_argument& error) {
    check_sentence(error.what(), "fuzzed.toml");
    return false;
  }
}

#include <stdexcept>

#include "experiments/host/recorded_teams.h"
#include "tests/fuzz/support.h"
#include "tests/fuzz/target.h"

bool fuzz::recording(std::string_view bytes) {
  const std::filesystem::path file = stored(bytes, "fuzzed.replies");
  try {
    host::recorded_config(file);
    return host::recorded_length(file).ticks > 0;
  } catch (const std::runtime_error& error) {
    check_sentence(error.what(), file);
    return false;
  }
}

#include <algorithm>
#include <stdexcept>

#include "experiments/host/play.h"
#include "experiments/schedule/design.h"
#include "experiments/schedule/schedule.h"
#include "tests/fuzz/support.h"
#include "tests/fuzz/target.h"

bool fuzz::design(std::string_view bytes) {
  try {
    const schedule::Design design =
        schedule::parse_design(std::string(bytes), "fuzzed.toml", host::check_realism);
    schedule::canonical(design);
    const std::size_t games = schedule::game_count(design);
    for (std::size_t n = 0; n < std::min<std::size_t>(games, 8); ++n) {
      try {
        host::check(schedule::game(design, n).config);
      } catch (const std::invalid_argument& error) {  // e.g. more robots than the rule set has
        check_sentence(error.what());
      }
    }
    return true;
  } catch (const std::invalid_argument& error) {
    check_sentence(error.what(), "fuzzed.toml");
    return false;
  }
}

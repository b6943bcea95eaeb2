#include <stdexcept>

#include "experiments/host/play.h"
#include "experiments/record/match_config.h"
#include "tests/fuzz/support.h"
#include "tests/fuzz/target.h"

bool fuzz::config_json(std::string_view bytes) {
  try {
    const record::MatchConfig config = record::match_config_from_json(std::string(bytes));
    record::to_json(config);
    host::check(config);
    return true;
  } catch (const std::invalid_argument& error) {
    check_sentence(error.what());
    return false;
  }
}

#include <stdexcept>

#include "experiments/record/match_record.h"
#include "tests/fuzz/support.h"
#include "tests/fuzz/target.h"

bool fuzz::record_json(std::string_view bytes) {
  try {
    const record::MatchRecord record = record::match_record_from_json(std::string(bytes));
    const std::string text = record::to_json(record);
    if (record::to_json(record::match_record_from_json(text)) != text) finding("a record changes when kept");
    record::counted_goals(record, 3);
    return true;
  } catch (const std::invalid_argument& error) {
    check_sentence(error.what());
    return false;
  }
}

#include <stdexcept>

#include "experiments/judge/failures.h"
#include "experiments/judge/game_file.h"
#include "experiments/judge/tables.h"
#include "tests/fuzz/support.h"
#include "tests/fuzz/target.h"

bool fuzz::judged_result(std::string_view bytes) {
  try {
    const judge::GameResult result = judge::game_from_json(std::string(bytes), "fuzzed.jsonl");
    const std::vector<judge::GameResult> games = {result};
    const auto tables = judge::tables(games);
    judge::as_markdown(tables);
    judge::as_csv(judge::failures(games, judge::acting_name));
    judge::to_json(result);
    return true;
  } catch (const std::invalid_argument& error) {
    check_sentence(error.what(), "fuzzed.jsonl");
    return false;
  }
}

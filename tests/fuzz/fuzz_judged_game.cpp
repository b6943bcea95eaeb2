#include <sstream>
#include <stdexcept>

#include "experiments/judge/game.h"
#include "experiments/judge/game_file.h"
#include "tests/fuzz/support.h"
#include "tests/fuzz/target.h"

bool fuzz::judged_game(std::string_view bytes) {
  const std::filesystem::path file = stored(bytes, "fuzzed.judged");
  try {
    std::ostringstream told;
    judge::Passage passage;
    passage.first = 0;
    passage.last = 1000;
    passage.out = &told;
    const judge::GameResult result = judge::judge_again(file, {judge::parse_shadow("rules=paper")}, passage);
    judge::to_json(result);
    return true;
  } catch (const std::invalid_argument& error) {
    check_sentence(error.what(), file);
    return false;
  }
}

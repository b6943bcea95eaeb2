#include <stdexcept>

#include "experiments/judge/snippet.h"
#include "tests/fuzz/support.h"
#include "tests/fuzz/target.h"

bool fuzz::snippet(std::string_view bytes) {
  const std::filesystem::path file = stored(bytes, "fuzzed.json");
  try {
    const judge::Snippet snippet = judge::read_snippet(file);
    judge::to_json(snippet);
    snippet.timeline();
    snippet.judge({});
    return true;
  } catch (const std::invalid_argument& error) {
    check_sentence(error.what(), file);
    return false;
  }
}

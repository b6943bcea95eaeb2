// Runs each part of a tick over a recorded game under callgrind, which counts:
// scripts/instructions reads the counts. The players are the plainest ones, so that changes of teams and
// skills count in the row "team" only.

#include <valgrind/callgrind.h>

#include <cstdio>

#include "tests/bench/parts.h"

namespace {

constexpr double seconds = 18;           // of the game: its kickoff, a foul, a penalty
constexpr std::size_t warm_ticks = 360;  // until the kickoff

}  // namespace

int main() {
  if (RUNNING_ON_VALGRIND == 0) {
    std::fputs("count_instructions: it counts nothing by itself; run scripts/instructions\n", stderr);
    return 2;
  }
  const hot::Recording recording = hot::recorded(hot::plain_team(), seconds);
  CALLGRIND_START_INSTRUMENTATION;
  for (const hot::PartOfTick& part : hot::parts()) {
    const auto runner = part.make(recording);
    for (std::size_t i = 0; i < recording.ticks.size(); ++i) {
      runner->prepare(recording.ticks[i]);
      if (i >= warm_ticks) CALLGRIND_TOGGLE_COLLECT;
      runner->run(recording.ticks[i]);
      if (i >= warm_ticks) CALLGRIND_TOGGLE_COLLECT;
    }
    CALLGRIND_DUMP_STATS_AT(part.name.c_str());
  }
  std::printf("%zu\n", recording.ticks.size() - warm_ticks);
}

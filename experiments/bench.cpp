#include "experiments/bench/bench.h"

#include <iostream>

#include "experiments/commands.h"

namespace commands {

int bench(const bench::BenchOptions& options, const RealismOptions& realism) {
  bench::BenchOptions settings = options;
  settings.game.realism = realism_config(realism);
  return bench::bench(settings, std::cout);
}

}  // namespace commands

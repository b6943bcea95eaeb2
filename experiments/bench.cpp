#include "experiments/bench/bench.h"

#include <iostream>

#include "experiments/commands.h"
#include "experiments/start.h"

namespace commands {

int bench(const bench::BenchOptions& options, const RealismOptions& realism) {
  check_temporary_folder(Games::Here);
  bench::BenchOptions settings = options;
  settings.game.realism = realism_config(realism);
  return bench::bench(settings, std::cout);
}

}  // namespace commands

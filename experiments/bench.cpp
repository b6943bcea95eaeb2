#include "experiments/bench/bench.h"

#include <iostream>

#include "experiments/commands.h"
#include "experiments/start.h"

namespace commands {

int bench(const bench::BenchOptions& options, const RealismOptions& realism, const std::string& isolation) {
  check_temporary_folder(Games::Here);
  bench::BenchOptions settings = options;
  settings.game.realism = realism_config(realism);
  settings.isolation = chosen_isolation(asked_isolation(isolation), "--isolation").level;
  return bench::bench(settings, std::cout);
}

}  // namespace commands

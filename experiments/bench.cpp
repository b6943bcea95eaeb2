#include "experiments/bench/bench.h"

#include <iostream>

#include "experiments/commands.h"

namespace commands {

int bench(const bench::BenchOptions& options) { return bench::bench(options, std::cout); }

}  // namespace commands

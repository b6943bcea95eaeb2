#include <iostream>

#include "experiments/commands.h"
#include "experiments/exit_code.h"
#include "experiments/experiment.h"
#include "experiments/report/formats.h"

namespace commands {

int report(const ReportOptions& options) {
  std::cout << report::formatted(summary(read_experiment(options.folder)), options.format);
  return done;
}

}  // namespace commands

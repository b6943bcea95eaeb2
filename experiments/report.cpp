#include <iostream>

#include "experiments/commands.h"
#include "experiments/exit_code.h"
#include "experiments/experiment.h"
#include "experiments/report/formats.h"

namespace commands {

int report(const ReportOptions& options) {
  const Experiment experiment = read_experiment(options.folder);
  std::cout << report::formatted(summary(experiment), options.format);
  if (options.format == "text" || options.format == "markdown") std::cout << conclusion(experiment);
  return done;
}

}  // namespace commands

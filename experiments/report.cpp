#include <iostream>
#include <stdexcept>

#include "experiments/commands.h"
#include "experiments/exit_code.h"
#include "experiments/experiment.h"
#include "experiments/process/whole_file.h"
#include "experiments/report/figures.h"
#include "experiments/report/formats.h"
#include "experiments/report/html.h"
#include "experiments/runner/audit.h"
#include "experiments/start.h"

namespace commands {

namespace {

void write_figures(const report::Summary& summary, const std::filesystem::path& folder) {
  make_folder(folder, "--figures");
  const std::vector<report::Figure> figures = report::figures(summary);
  if (figures.empty())
    throw std::invalid_argument("there is no figure yet: no condition has a complete pair");
  for (const report::Figure& figure : figures) {
    const std::filesystem::path file = folder / (figure.name + ".svg");
    process::write_whole(file, report::drawn(figure));
    std::cout << file.string() << "  " << figure.caption << "\n";
  }
}

}  // namespace

int report(const ReportOptions& options) {
  const Experiment experiment = read_experiment(options.folder);
  const report::Summary found = summary(experiment);
  if (options.html) {
    std::cout
        << report::write_html(options.folder, found, experiment.attempts, goes_on(experiment, found)).string()
        << "\n";
  }
  if (options.figures) write_figures(found, *options.figures);
  if (!options.html && !options.figures) std::cout << report::formatted(found, options.format);
  return done;
}

}  // namespace commands

#include "experiments/start.h"

#include "experiments/host/play.h"
#include "experiments/runner/program_files.h"
#include "experiments/schedule/schedule.h"

namespace commands {

schedule::Design checked_design(const std::filesystem::path& file) {
  schedule::Design design = schedule::read_design(file, host::check_realism);
  for (std::size_t i = 0; i < design.conditions.size(); ++i) {
    const schedule::Condition& condition = design.conditions[i];
    const std::string who = file.string() + ": condition '" + condition.name + "', team ";
    if (!condition.a_source) runner::team_files(condition.a, who + "a");
    if (!condition.b_source) runner::team_files(condition.b, who + "b");
    host::check(schedule::game(design, 2 * i).config);
  }
  return design;
}

std::filesystem::path usual_folder(const schedule::Design& design) {
  return std::filesystem::path("results") / design.name;
}

}  // namespace commands

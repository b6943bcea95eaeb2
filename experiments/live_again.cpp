#include "experiments/live_again.h"

#include <stdexcept>

#include "experiments/builds/builds.h"
#include "experiments/start.h"

namespace commands {

host::Options live_settings(schedule::Design& design, const std::filesystem::path& folder,
                            const LiveOptions& options, std::string* sentence) {
  if (builds::any_source(design) && !options.build) {
    throw std::invalid_argument(
        "its teams are built by commands that the folder names; --build allows that, with all your rights");
  }
  std::string told;
  host::Options settings = isolated_game(options.isolation, &told);
  if (settings.isolation == process::Isolation::None && options.isolation.level.empty()) {
    throw std::invalid_argument("the folder's programs would be started with " + told +
                                "; --isolation none allows that, with all your rights");
  }
  settings.hidden = {std::filesystem::weakly_canonical(std::filesystem::absolute(folder))};
  build_teams(design, folder);
  if (sentence != nullptr) *sentence = told;
  return settings;
}

}  // namespace commands

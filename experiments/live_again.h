#pragma once

#include <filesystem>

#include "experiments/host/play.h"
#include "experiments/isolation.h"
#include "experiments/schedule/design.h"

namespace commands {

/// How much the reader of a result folder lets the programs do that it names: somebody else may have made it.
struct LiveOptions {
  IsolationOptions isolation;  ///< level empty: the strongest that the machine allows, if there is any
  bool build = false;          ///< teams from git are built with the commands that the folder names
};

/// Builds the teams and says how they are started, by what the reader allows and not by what the folder says.
///
/// @param sentence  about the isolation, if wanted
/// @throws std::invalid_argument saying what has to be allowed first
host::Options live_settings(schedule::Design& design, const std::filesystem::path& folder,
                            const LiveOptions& options, std::string* sentence = nullptr);

}  // namespace commands

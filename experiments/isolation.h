#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "experiments/host/play.h"
#include "experiments/process/isolation.h"

namespace commands {

/// What the user says about isolation on a command line.
struct IsolationOptions {
  std::string level;                           ///< empty: the strongest the machine allows
  std::vector<std::filesystem::path> visible;  ///< what teams see nevertheless
};

/// What teams get.
struct ChosenIsolation {
  process::Isolation level = process::Isolation::None;
  std::string sentence;  ///< "isolation network", or with why it is not more
};

/// The level of a flag; nothing when it is not given.
/// @throws std::invalid_argument naming the word and the known ones
std::optional<process::Isolation> asked_isolation(const std::string& word);

/// What was asked for, or the strongest that the machine allows: that is tried.
///
/// @param asked_by  how a message calls it
/// @throws std::invalid_argument when what was asked for is not possible
ChosenIsolation chosen_isolation(std::optional<process::Isolation> asked, const std::string& asked_by);

/// Absolute paths of what must be there.
/// @throws std::invalid_argument naming what is not
std::vector<std::filesystem::path> visible_paths(const std::vector<std::filesystem::path>& paths,
                                                 const std::string& asked_by);

/// For a game of this process.
/// @param sentence  of ChosenIsolation, if wanted
host::Options isolated_game(const IsolationOptions& options, std::string* sentence = nullptr);

/// For a game of a worker, which is told what was chosen: nothing is tried again.
host::Options game_as_told(const IsolationOptions& options, const std::vector<std::filesystem::path>& hidden);

/// The flags that tell it.
std::vector<std::string> worker_flags(process::Isolation level,
                                      const std::vector<std::filesystem::path>& visible,
                                      const std::filesystem::path& hidden);

}  // namespace commands

#pragma once

#include <filesystem>
#include <string>

#include "experiments/schedule/design.h"

namespace commands {

/// A design file, read and checked as far as can be without building or playing anything: its values, its
/// games, and that the programs of teams that need no building exist.
///
/// @throws std::invalid_argument in one sentence
schedule::Design checked_design(const std::filesystem::path& file);

/// Builds the teams that come from git (builds::prepare); HUP, Ctrl-C and TERM end a build with
/// all that it has started.
///
/// @throws std::invalid_argument  in one sentence, when that went wrong
/// @throws builds::Interrupted    with the signal
void build_teams(schedule::Design& design, const std::filesystem::path& result_folder);

/// Where its results go if the user does not say: results/<name>.
std::filesystem::path usual_folder(const schedule::Design& design);

/// Makes the folder a flag names, if there is none.
///
/// @throws std::invalid_argument naming flag, folder and reason
void make_folder(const std::filesystem::path& folder, const std::string& flag);

/// Before anything is written: a folder with other things in it than results, as somebody's sources, is not
/// the place for them.
///
/// @param design  a design file may lie where its results go
/// @throws record::StorageError naming folder and thing
void check_result_folder(const std::filesystem::path& folder, const std::filesystem::path& design);

/// Games of this process alone, or of workers with folders of their own inside ours.
enum class Games { Here, OfWorkers };

/// Checks before anything is started that the folder for temporary files is there and its path is short
/// enough for the teams' sockets.
///
/// @throws std::invalid_argument about TMPDIR
void check_temporary_folder(Games games);

}  // namespace commands

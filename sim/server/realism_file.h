#pragma once

#include <string>

#include "sim/engine/realism.h"

namespace server {

/// The realism that a word of the command line means: the name of a preset, or the path of a TOML file.
///
/// @throws std::invalid_argument in one sentence, for a mistake in a file beginning with "FILE:LINE: "
engine::Realism named_realism(const std::string& word);

/// The table [realism] of a TOML text: `preset` (without it: measured), then numbers under their keys, dotted
/// or in tables inside. It is what `matchday realism` prints and `ssl-autoref calibrate` writes; other tables
/// do not count, so the file may be a design.
///
/// @param file  for the sentence
/// @throws std::invalid_argument "FILE:LINE: what is wrong"
engine::Realism parse_realism(const std::string& text, const std::string& file);

}  // namespace server

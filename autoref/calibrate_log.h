#pragma once

#include <cstddef>
#include <filesystem>
#include <iosfwd>

#include "autoref/calibrate/observations.h"

namespace autoref {

struct CalibrateOptions {
  std::filesystem::path file;
  std::filesystem::path out;  ///< the preset; empty: none is written
  bool json = false;
  std::size_t most_kept = calibrate::most_kept;  ///< images and objects in them; what follows is left out
};

/// Measures a league log, prints what was found as a table and writes it as a realism
/// preset, whole or not at all.
///
/// Of a log that is longer than can be kept in memory the beginning is measured; `errors` says so.
///
/// @return 0; 2 when the log is damaged, cut short or without geometry: what could be found is printed and
///         written, one sentence is on `errors`
/// @throws std::exception with one sentence when nothing can be found or written
int calibrate_log(const CalibrateOptions& options, std::ostream& out, std::ostream& errors);

}  // namespace autoref

#pragma once

#include <filesystem>
#include <iosfwd>

namespace autoref {

struct CalibrateOptions {
  std::filesystem::path file;
  std::filesystem::path out;  ///< the preset; empty: none is written
  bool json = false;
};

/// Measures a league log, prints what was found as a table and writes it as a realism
/// preset, whole or not at all.
///
/// @return 0; 2 when the log is damaged, cut short or without geometry: what could be found is printed and
///         written, one sentence is on `errors`
/// @throws std::exception with one sentence when nothing can be found or written
int calibrate_log(const CalibrateOptions& options, std::ostream& out, std::ostream& errors);

}  // namespace autoref

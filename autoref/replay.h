#pragma once

#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>

namespace autoref {

struct ReplayOptions {
  std::filesystem::path file;
  std::string rules;  ///< empty: those of the log, or the default
  bool json = false;
  enum class Mode { Auto, Referee, Watch } mode = Mode::Auto;
};

/// Referees a league log again (logs of ours) or watches another referee at work (all others), and prints
/// what it finds, then a summary.
///
/// @return 0; 2 when the log is damaged or cut short: what could be read is on `out`,
///         one sentence is on `errors`
/// @throws std::exception with one sentence when nothing can be read at all
int replay(const ReplayOptions& options, std::ostream& out, std::ostream& errors);

}  // namespace autoref

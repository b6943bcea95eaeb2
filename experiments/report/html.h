#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "experiments/record/attempt.h"
#include "experiments/report/figures.h"
#include "experiments/report/health.h"
#include "experiments/report/summary.h"

namespace report {

/// All that one report page shows.
struct Page {
  Summary summary;
  Health health;
  std::span<const record::Attempt> attempts;
  std::vector<std::pair<Figure, std::string>> figures;  ///< with their SVG
  std::string no_figures;                               ///< why there are none; empty otherwise
  std::string manifest;                                 ///< text of manifest.json; empty: there is none
  std::string made;                                     ///< date and time, UTC
  bool refresh = false;                                 ///< the page loads itself again every 20 s
};

/// One HTML file that needs nothing but itself: opens from a disk, without a network.
std::string as_html(const Page& page);

/// Draws the figures, reads the manifest beside the ledger and writes `folder`/report.html, replacing an
/// older one as a whole. Loads itself again while games are missing.
///
/// @return the file
/// @throws std::system_error when it cannot be written
std::filesystem::path write_html(const std::filesystem::path& folder, const Summary& summary,
                                 std::span<const record::Attempt> attempts, bool goes_on);

}  // namespace report

#pragma once

#include <chrono>
#include <functional>
#include <iosfwd>
#include <optional>

#include "experiments/record/ledger.h"
#include "experiments/runner/manifest.h"
#include "experiments/runner/result_folder.h"
#include "experiments/runner/signals.h"

namespace runner {

/// How the ledger of a run is opened.
struct Opening {
  std::optional<std::string>
      before{};         ///< hash of a smaller experiment in the folder that goes on with this one
  bool remote = false;  ///< the folder is on a network file system
  std::chrono::milliseconds patience{};  ///< for another program that holds the ledger
};

/// Opens the ledger of a run and writes its manifest, if there is none; waits while another program holds the
/// ledger, which is said once.
///
/// @param signal  set to the number of the signal that came first; then there is no ledger
/// @throws record::StorageError as Ledger::open, when the patience has come to its end, and when the manifest
///         is of games with another isolation
std::optional<record::Ledger> open_ledger(const ResultFolder& folder, const Manifest& manifest,
                                          const Opening& opening, Signals& signals, int& signal,
                                          std::ostream& out);

}  // namespace runner

#include "experiments/runner/ledger_opening.h"

#include <ostream>
#include <stdexcept>

#include "experiments/record/checksum.h"
#include "sim/files/regular_file.h"

namespace runner {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest = std::size_t{64} << 20;  // [bytes] of a manifest; ours
constexpr std::chrono::milliseconds look{200};          // between two tries, which wait a little themselves

bool names(const fs::path& file, const std::string& hash) {
  if (!fs::exists(file)) return false;
  try {
    return files::text_of(file, longest).find(hash) != std::string::npos;
  } catch (const std::runtime_error& error) {
    throw record::StorageError(error.what());
  }
}

/// The level that a manifest names, if it can be read: `matchday verify` tells of one that cannot.
std::string level_in(const fs::path& manifest) {
  if (!fs::exists(manifest)) return {};
  try {
    return level_of(read_manifest(manifest).isolation);
  } catch (const record::StorageError&) {
    return {};
  }
}

/// Whether the manifest there is of another level, which is no harm as long as there are no games.
///
/// Games of teams that saw more of the machine and of teams that saw less are no one experiment, and the
/// manifest can name one level only.
bool other_isolation(const fs::path& file, const record::Ledger& ledger, const Manifest& manifest) {
  const std::string before = level_in(file);
  const std::string now = level_of(manifest.isolation);
  if (before.empty() || now.empty() || before == now) return false;
  if (ledger.attempts(record::Detail::WithoutTimeline).empty()) return true;
  throw record::FolderTaken(file.string() + ": the games of this folder were played with isolation " +
                            before + ", now it would be " +
                            manifest.isolation.substr(manifest.isolation.find(now)) +
                            "; write isolation = \"" + before + "\" in the design (compare: --isolation " +
                            before + "), or give another --out");
}

/// Written when the folder is made and left alone once there are games; the ledger knows its checksum.
void keep_manifest(const ResultFolder& folder, record::Ledger& ledger, const Manifest& manifest) {
  const fs::path file = folder.manifest();
  const std::string name = file.filename().string();
  const bool other = other_isolation(file, ledger, manifest);
  for (const record::KeptFile& known : ledger.files()) {
    if (!other && known.path == name && fs::exists(file)) return;
  }
  // One that a killed run did not come to write down, or of an older ledger, is taken as it is.
  if (other || !names(file, manifest.experiment_hash)) write_manifest(file, manifest);
  ledger.add(
      record::KeptFile{name, static_cast<std::int64_t>(fs::file_size(file)), record::checksum_of_file(file)});
}

}  // namespace

std::optional<record::Ledger> open_ledger(const ResultFolder& folder, const Manifest& manifest,
                                          const Opening& opening, Signals& signals, int& signal,
                                          std::ostream& out) {
  const record::Experiment experiment{manifest.experiment_hash, manifest.design.text};
  const record::Journal journal = opening.remote ? record::Journal::Rollback : record::Journal::WriteAhead;
  const auto until = std::chrono::steady_clock::now() + opening.patience;
  bool grown = !opening.before;
  for (bool told = false;; told = true) {
    try {
      if (!grown) {
        other_isolation(
            folder.manifest(),
            record::Ledger::open(folder.ledger(), {*opening.before, manifest.design.text}, journal),
            manifest);
        record::Ledger::grow(folder.ledger(), *opening.before, experiment,
                             folder.manifest().filename().string(), journal);
      }
      grown = true;
      record::Ledger ledger = record::Ledger::open(folder.ledger(), experiment, journal);
      keep_manifest(folder, ledger, manifest);
      return ledger;
    } catch (const record::LedgerBlocked& error) {
      if (std::chrono::steady_clock::now() > until) throw;
      if (!told) out << error.what() << ": waiting until it is free" << std::endl;
    }
    if (const auto came = signals.wait(look)) {
      signal = *came;
      return std::nullopt;
    }
  }
}

}  // namespace runner

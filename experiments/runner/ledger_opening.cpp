#include "experiments/runner/ledger_opening.h"

#include <fstream>
#include <iterator>
#include <ostream>

#include "experiments/record/checksum.h"

namespace runner {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::milliseconds look{200};  // between two tries, which wait a little themselves

bool names(const fs::path& file, const std::string& hash) {
  std::ifstream stream(file);
  const std::string text((std::istreambuf_iterator<char>(stream)), {});
  return text.find(hash) != std::string::npos;
}

/// Written when the folder is made and left alone afterwards; the ledger knows its checksum.
void keep_manifest(const ResultFolder& folder, record::Ledger& ledger, const Manifest& manifest) {
  const fs::path file = folder.manifest();
  const std::string name = file.filename().string();
  for (const record::KeptFile& known : ledger.files()) {
    if (known.path == name && fs::exists(file)) return;
  }
  // One that a killed run did not come to write down, or of an older ledger, is taken as it is.
  if (!names(file, manifest.experiment_hash)) write_manifest(file, manifest);
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

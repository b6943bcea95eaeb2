#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "experiments/record/attempt.h"
#include "experiments/record/audit.h"
#include "experiments/record/kept_file.h"

namespace record {

/// The ledger or its folder cannot be used: damaged, of a newer version, locked, of another experiment.
struct StorageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The folder is somebody else's, of another experiment or another run: the same command again cannot help.
struct FolderTaken : StorageError {
  using StorageError::StorageError;
};

/// Another program holds the ledger, or its disk is full: the same call may succeed later.
struct LedgerBlocked : StorageError {
  using StorageError::StorageError;
};

/// What an experiment's ledger says about itself.
struct Experiment {
  std::string hash;    ///< of everything that decides its games, 32 hexadecimal digits
  std::string design;  ///< text of the design file
  bool operator==(const Experiment&) const = default;
};

/// How much of every attempt is read: the timelines of calls are nine tenths of a full game's record.
enum class Detail { Whole, WithoutTimeline };

/// How a ledger is written.
enum class Journal {
  /// readers never wait for the writer nor the writer for readers; needs memory that processes share through
  /// files, which network file systems do not have
  WriteAhead,
  Rollback  ///< a reader in the middle of a query makes the writer wait
};

/// Rows of one table by what their checksums say.
struct RowCheck {
  std::int64_t whole = 0;
  std::int64_t unknown = 0;          ///< without a checksum: written before schema 3
  std::vector<std::string> damaged;  ///< a sentence for each
};

/// What a look at every row found.
struct LedgerCheck {
  RowCheck attempts;
  RowCheck audits;
  RowCheck files;
  RowCheck experiment;
  // What the rows that are not damaged hold; attempts without their timelines.
  std::vector<Attempt> readable_attempts;
  std::vector<Audit> readable_audits;
  std::vector<KeptFile> readable_files;
};

/// All attempts of an experiment in one SQLite file: the only state of a run.
///
/// One row per attempt in the table `attempts`; the view `games` shows the same with the match statistics as
/// columns, for people with a query. A row is written once, in a transaction of its own that is on the disk
/// when `add` returns, with a checksum that is compared whenever it is read. One process writes; any number
/// may read meanwhile.
class Ledger {
 public:
  /// `PRAGMA user_version`. 1: without match statistics; 2: without checksums and the table `files`; 3: without
  /// the numbers of audits and files. All are read as they are, and brought up to date when opened for writing.
  static constexpr int schema = 4;

  /// Opens the ledger for writing; a file that does not exist is created for that experiment.
  ///
  /// @throws LedgerBlocked when another program holds it
  /// @throws StorageError naming the file: not a ledger, damaged, newer schema,
  ///         another experiment (both hashes)
  static Ledger open(const std::filesystem::path& file, const Experiment& experiment,
                     Journal journal = Journal::WriteAhead);

  /// Makes the ledger of `before` (a hash) that of a larger experiment, whose first games are the same. The
  /// files `forgotten` will be written anew.
  ///
  /// @throws StorageError as open
  static void grow(const std::filesystem::path& file, const std::string& before, const Experiment& larger,
                   const std::string& forgotten = {}, Journal journal = Journal::WriteAhead);

  /// Opens an existing ledger for reading only, also one that a killed run left behind, or on a medium that
  /// cannot be written.
  ///
  /// @throws StorageError as above, and when there is no such file
  static Ledger read(const std::filesystem::path& file);

  Ledger(Ledger&&) noexcept;
  Ledger& operator=(Ledger&&) noexcept;
  ~Ledger();

  /// Writes one attempt, and the files that are kept of it.
  ///
  /// @throws LedgerBlocked when another program holds it or the disk is full: nothing is written then
  /// @throws StorageError when it is already there or cannot be written
  void add(const Attempt& attempt, std::span<const KeptFile> files = {});

  /// All attempts, by condition name, pair, leg and attempt.
  ///
  /// @throws StorageError naming the game and attempt whose row is not what was written
  std::vector<Attempt> attempts(Detail detail = Detail::Whole) const;

  /// Writes one audit, in place of an earlier one of the same attempt.
  ///
  /// @throws as for an attempt
  void add(const Audit& audit);

  /// All audits, by condition name, pair, leg and attempt.
  std::vector<Audit> audits() const;

  /// Writes down a file, in place of what was known of it.
  void add(const KeptFile& file);
  /// Forgets the files below a folder, before they are thrown away.
  void forget_files(const std::string& folder);
  /// All files that are written down, by path.
  std::vector<KeptFile> files() const;

  Experiment experiment() const;
  int version() const;  ///< the schema of the file

  /// Looks at every row.
  LedgerCheck check() const;

  /// Makes one file of it that can be read from anywhere, when nobody else holds it;
  /// the ledger may be used on.
  void put_together();

  struct Connection;  ///< to the file; for the sources of this folder

 private:
  explicit Ledger(std::unique_ptr<Connection> connection);
  std::unique_ptr<Connection> connection_;
};

}  // namespace record

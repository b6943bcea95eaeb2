#pragma once

#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "experiments/record/attempt.h"
#include "experiments/record/audit.h"

namespace record {

/// The ledger or its folder cannot be used: damaged, of a newer version, locked, of another experiment.
struct StorageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The folder is somebody else's, of another experiment or another run: the same command again cannot help.
struct FolderTaken : StorageError {
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

/// All attempts of an experiment in one SQLite file: the only state of a run.
///
/// One row per attempt in the table `attempts`; the view `games` shows the same with the match statistics as
/// columns, for people with a query. A row is written once, in a transaction of its own that is on the disk
/// when `add` returns. One process writes; any number may read meanwhile.
class Ledger {
 public:
  /// `PRAGMA user_version`. 1: without match statistics; read as it is, and given the view `games` when it is
  /// opened for writing.
  static constexpr int schema = 2;

  /// Opens the ledger for writing; a file that does not exist is created for that experiment.
  ///
  /// @throws StorageError naming the file: not a ledger, damaged, newer schema, another experiment (both
  /// hashes)
  static Ledger open(const std::filesystem::path& file, const Experiment& experiment);

  /// Makes the ledger of `before` (a hash) that of a larger experiment, whose first games are the same.
  ///
  /// @throws StorageError as open
  static void grow(const std::filesystem::path& file, const std::string& before, const Experiment& larger);

  /// Opens an existing ledger for reading only.
  ///
  /// @throws StorageError as above, and when there is no such file
  static Ledger read(const std::filesystem::path& file);

  Ledger(Ledger&&) noexcept;
  Ledger& operator=(Ledger&&) noexcept;
  ~Ledger();

  /// Writes one attempt.
  ///
  /// @throws StorageError when it is already there or cannot be written
  void add(const Attempt& attempt);

  /// All attempts, by condition name, pair, leg and attempt.
  std::vector<Attempt> attempts(Detail detail = Detail::Whole) const;

  /// Writes one audit, in place of an earlier one of the same attempt.
  ///
  /// @throws StorageError when it cannot be written
  void add(const Audit& audit);

  /// All audits, by condition name, pair, leg and attempt.
  std::vector<Audit> audits() const;

  Experiment experiment() const;

 private:
  struct Connection;
  explicit Ledger(std::unique_ptr<Connection> connection);
  std::unique_ptr<Connection> connection_;
};

}  // namespace record

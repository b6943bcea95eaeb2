#pragma once

#include <filesystem>
#include <string>

namespace runner {

/// The folder of one experiment's results, held for writing by one process at a time.
///
/// The lock goes with the process, however it ends.
class ResultFolder {
 public:
  /// Makes the folder if there is none, and locks it.
  ///
  /// @throws record::StorageError when it cannot be made, holds links (see check_links) or another run holds it
  explicit ResultFolder(const std::filesystem::path& path);
  ResultFolder(const ResultFolder&) = delete;
  ResultFolder& operator=(const ResultFolder&) = delete;
  ~ResultFolder();

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path ledger() const { return path_ / "ledger.sqlite"; }
  std::filesystem::path manifest() const { return path_ / "manifest.json"; }
  /// games/<id>/<attempt>: what an attempt leaves behind.
  std::filesystem::path game(const std::string& id, int attempt) const;

  std::filesystem::path status() const { return path_ / "status.json"; }
  std::filesystem::path scratch_note() const { return path_ / "scratch"; }
  /// audits/<id>: a game that is played again to compare its hash.
  std::filesystem::path audit(const std::string& id) const { return path_ / "audits" / id; }
  /// preflight/<number>
  std::filesystem::path preflight() const { return path_ / "preflight"; }

  int descriptor() const { return lock_; }  ///< of the folder itself, whatever it is called meanwhile

  /// A link in the folder would make the run write, and throw away, somewhere else.
  ///
  /// @throws record::StorageError naming the first: of its entries, and of those of games, audits and preflight
  void check_links() const;
  /// The same of the way to a game or audit, just before it is used.
  void check_links(const std::filesystem::path& below) const;

  /// Throws away what an attempt at a game left behind.
  void forget_game(const std::string& id, int attempt) const;
  /// Throws away what an audit left behind.
  void forget_audit(const std::string& id) const;

 private:
  std::filesystem::path path_;  ///< absolute
  int lock_ = -1;
};

}  // namespace runner

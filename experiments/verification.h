#pragma once

#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

#include "experiments/exit_code.h"
#include "experiments/record/ledger.h"
#include "experiments/runner/check_files.h"

namespace commands {

/// What came of a game that was to be played again.
struct GameAgain {
  enum class Result : std::uint8_t {
    Same,        ///< the same hash
    Different,   ///< another hash, or no end, where only damage explains it
    Unverified,  ///< not played, or an outcome that says nothing; `reason` says why
  };
  std::string game;
  int attempt = 1;
  bool from_replies = false;  ///< recorded ones; otherwise from its seed, with live teams
  Result result = Result::Unverified;
  std::string reason;
};

/// What is known of a result folder after all of it was looked at.
struct Verification {
  struct Rows {
    std::string table;
    std::int64_t whole = 0;
    std::int64_t unknown = 0;          ///< without a checksum, by an older matchday
    std::vector<std::string> damaged;  ///< a sentence for each
  };
  struct Program {
    std::string path;
    std::string state;  ///< "same", "changed", "missing"
  };

  std::string folder;
  std::vector<Rows> rows;  ///< by table
  runner::FileCheck files;
  bool manifest = false;  ///< there is one
  std::string matchday;   ///< its version
  std::string commit;
  std::string experiment;                      ///< hash that the manifest's contents make
  std::vector<std::string> manifest_problems;  ///< a sentence for each
  std::string unknown_design;                  ///< why the ledger's cannot be compared with the manifest's
  std::vector<Program> programs;
  int wanted = 0;            ///< games to be played again
  std::size_t finished = 0;  ///< games of which they are a sample
  std::vector<GameAgain> games;

  std::size_t damages() const;  ///< findings that something is not as it was written
};

/// Why not everything is verified, a clause for each; empty: all that was asked for is.
std::vector<std::string> unverified(const Verification& all);

/// `done`; `faults` when something could not be verified; `storage` when something is not as it was written.
ExitCode exit_code(const Verification& all);

/// The last sentence: what was verified and what was not.
std::string verdict(const Verification& all);

// Its parts for people, lines each, at most the first `most_told` sentences of a kind.
inline constexpr std::size_t most_told = 20;
void tell_rows(const Verification::Rows& rows, std::ostream& out);
void tell_files(const Verification& all, std::ostream& out);
void tell_manifest(const Verification& all, std::ostream& out);
void tell_game(const GameAgain& game, std::ostream& out);
void tell_verdict(const Verification& all, std::ostream& out);

/// All of it for programs, with at most `most_told` sentences of a kind and their number.
std::string to_json(const Verification& all);

}  // namespace commands

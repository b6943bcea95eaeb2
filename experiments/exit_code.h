#pragma once

namespace commands {

/// What matchday ends with; the texts are in `matchday --help`.
enum ExitCode : int {
  done = 0,              ///< also when a sequential test says that A is better
  different = 1,         ///< replay: the game went differently
  bad_input = 2,         ///< a flag, a file, a value
  preflight_failed = 3,  ///< the teams cannot play: the short game before the first one
  /// too many void games; play: a game that ended by a fault; verify: not all could be verified
  faults = 4,
  storage = 5,       ///< result folder or ledger; verify: not as written
  h0_accepted = 10,  ///< run, compare: the sequential test says that A is not better
  undecided = 11,    ///< run, compare: neither decision nor precision when all games were played
  internal = 70,     ///< a mistake in matchday itself (sysexits.h, EX_SOFTWARE)
  // 74 and 141: console::ExitCode
  signal_base = 128,  ///< plus the signal's number: 130 after Ctrl-C, 143 after TERM
};

}  // namespace commands

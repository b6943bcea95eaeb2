#pragma once

#include <functional>
#include <string>

// What our programs print, and how they end when it cannot be printed.
namespace console {

/// Exit codes of every program that prints.
enum ExitCode : int {
  cannot_print = 74,   ///< standard output took not everything (sysexits.h, EX_IOERR)
  nobody_reads = 141,  ///< whoever read standard output has gone, as `| head -1` does: 128 + SIGPIPE
};

/// Runs a program's main function with std::cout and std::cerr watched, and returns what to end with.
///
/// Text from outside is made printable on its way out. When standard output could not take everything, one
/// sentence on standard error says so and the code is `cannot_print`; when its reader has gone, nothing is
/// said and it is `nobody_reads`. std::cout is bad from then on, but nothing ends because of it: SIGPIPE is
/// ignored, and what standard error does not take is dropped.
///
/// @param program  its name, for the sentence
int run_program(const std::string& program, const std::function<int()>& main);

/// What redraws a line of progress: the only control sequence that standard error lets through.
inline constexpr const char* clear_line = "\r\033[K";

}  // namespace console

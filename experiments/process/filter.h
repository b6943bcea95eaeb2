#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "experiments/process/program.h"

namespace process {

/// A program that reads something and prints something, started without a shell.
struct Filter {
  std::vector<std::string> arguments;  ///< the first names the program, see find_program()
  std::string_view input{};            ///< its standard input: a file in memory, which it may read repeatedly
  std::filesystem::path directory{};   ///< to work in; empty: ours
  std::vector<std::pair<std::string, std::string>> environment{};  ///< added to ours, or in place of ours
  std::chrono::milliseconds patience{60'000};                      ///< then it is ended
  std::chrono::milliseconds grace{0};                              ///< between TERM and that KILL
  std::size_t longest_output = std::size_t{64} << 20;              ///< [bytes] what is more is not kept
  bool errors_too = false;  ///< standard error is part of the output; otherwise it is thrown away
};

/// What came of it.
struct Filtered {
  bool well = false;    ///< it ended by itself, in time, with code 0
  std::string output;   ///< its standard output
  std::string problem;  ///< "took longer than 60 s"; empty when `well`
};

/// Runs it to its end; nothing is left of it afterwards, no process and no file. It ends with us.
///
/// @throws StartError naming the program and the cause
Filtered filter(const Filter& filter);

}  // namespace process

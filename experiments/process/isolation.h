#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace process {

/// How much of the machine a program sees; each level has all of those before it.
enum class Isolation : std::uint8_t {
  None,    ///< what we see
  Files,   ///< home and temporary folders of its own, its own processes only, all else read-only
  Network  ///< no network either
};

const char* name(Isolation level);  ///< "none", "files", "network"
std::optional<Isolation> isolation_from_name(std::string_view word);

/// What is different for one program that is started isolated. All paths are absolute.
struct Cell {
  Isolation level = Isolation::None;
  std::vector<std::filesystem::path> hidden;  ///< folders that are empty for it
  std::vector<std::filesystem::path>
      visible;  ///< seen even where or in what is hidden, in the home, in /tmp; read-only
  std::vector<std::filesystem::path> writable;  ///< the same, to be written in
};

/// The folders a program needs, as its command says: where it is installed, and what its arguments name.
///
/// @param arguments  the first names the program, see find_program()
/// @param directory  in which it works; empty: ours
/// @return           nothing when there is no such program
std::vector<std::filesystem::path> needed_folders(const std::vector<std::string>& arguments,
                                                  const std::filesystem::path& directory);

/// The folders that one program needs and another can do without: those that can be hidden from it.
///
/// @param own        what the other one needs
/// @param directory  in which that works; empty: ours
std::vector<std::filesystem::path> not_shared(const std::vector<std::filesystem::path>& others,
                                              const std::vector<std::filesystem::path>& own,
                                              const std::filesystem::path& directory);

/// A command that starts another one in a cell: bubblewrap with its arguments, to be executed as it is.
///
/// @param status   open file to which bubblewrap reports how the program ended; not passed on to it
/// @param program  absolute
/// @pre cell.level is not None
/// @throws StartError when bubblewrap is not installed
std::vector<std::string> isolated_command(const Cell& cell, int status, const std::filesystem::path& program,
                                          const std::vector<std::string>& arguments,
                                          const std::filesystem::path& directory);

/// What this machine allows.
struct IsolationLimit {
  Isolation strongest = Isolation::None;
  std::string problem;  ///< why there is no more, in one sentence; empty: there is nothing above
  std::string gap;      ///< what a cell does not keep from programs here, though it should; empty: nothing
};

/// Tries it by starting programs, the strongest level first; takes some 10 ms.
IsolationLimit isolation_limit();

}  // namespace process

#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace process {

/// A program could not be started; the message is one sentence that names it and the cause.
class StartError : public std::runtime_error {
 public:
  /// @param cause  errno, where a call of the system failed
  explicit StartError(const std::string& sentence, int cause = 0)
      : std::runtime_error(sentence), cause_(cause) {}
  int cause() const { return cause_; }

 private:
  int cause_;
};

/// The same, but nothing is wrong with the program: the machine has no room for another process.
class MachineError : public StartError {
 public:
  using StartError::StartError;
};

/// Whether an errno says that the machine has no process, memory or open file left: it may pass by itself.
bool is_shortage(int cause);

/// The absolute path of a program as a user names it.
///
/// A name with a slash is a path, seen from `directory` (empty: the present one). A bare name is looked up
/// beside the running program (so that `matchday` finds the teams built with it), then in PATH.
///
/// @throws StartError when there is no such file or it is not executable
std::filesystem::path find_program(const std::string& name, const std::filesystem::path& directory = {});

}  // namespace process

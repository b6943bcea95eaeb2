#include "experiments/process/filter.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>

#include "experiments/process/child.h"

namespace process {
namespace {

/// A file without a name, gone with its last reader.
class MemoryFile {
 public:
  explicit MemoryFile(const char* name) : file_(::memfd_create(name, MFD_CLOEXEC)) {
    if (file_ < 0) throw StartError("cannot make a file in memory: " + text_of(errno));
  }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  ~MemoryFile() { ::close(file_); }

  void write(std::string_view text) const {
    while (!text.empty()) {
      const ssize_t count = ::write(file_, text.data(), text.size());
      if (count < 0 && errno != EINTR) throw StartError("cannot write into memory: " + text_of(errno));
      if (count > 0) text.remove_prefix(static_cast<std::size_t>(count));
    }
  }

  std::string read() const {
    std::string text;
    std::array<char, 65536> buffer;
    for (off_t at = 0;;) {
      const ssize_t count = ::pread(file_, buffer.data(), buffer.size(), at);
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) return text;
      text.append(buffer.data(), static_cast<std::size_t>(count));
      at += count;
    }
  }

  /// As whoever runs in this process opens it.
  std::filesystem::path path() const { return "/proc/self/fd/" + std::to_string(file_); }

 private:
  static std::string text_of(int error) { return std::generic_category().message(error); }
  int file_;
};

}  // namespace

Filtered filter(const Filter& filter) {
  const MemoryFile input("input");
  const MemoryFile output("output");
  input.write(filter.input);
  Command command;
  command.arguments = filter.arguments;
  command.environment = filter.environment;
  command.input = input.path();
  command.output = output.path();
  command.output_limit = filter.longest_output;
  command.errors_apart = !filter.errors_too;
  command.directory = filter.directory;
  Filtered result;
  Child child(command);
  const bool ended = child.wait(filter.patience);
  const Exit exit = child.stop(ended ? std::chrono::milliseconds{0} : filter.grace);
  if (!ended) {
    result.problem = "took longer than " + std::to_string(filter.patience.count() / 1000) + " s";
  } else if (child.output().discarded() > 0) {
    result.problem = "printed more than " + std::to_string(filter.longest_output) + " bytes";
  } else if (!exit.clean()) {
    result.problem = exit.describe();
  }
  result.well = result.problem.empty();
  result.output = output.read();
  return result;
}

}  // namespace process

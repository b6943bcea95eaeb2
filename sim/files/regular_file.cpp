#include "sim/files/regular_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace files {
namespace {

constexpr std::size_t piece = 1 << 16;  // [bytes] read at once

std::string problem_of(mode_t mode) {
  const auto is = [](const char* kind) { return std::string("is ") + kind + ", a regular file is needed"; };
  switch (mode & S_IFMT) {
    case S_IFREG:
      return "";
    case S_IFIFO:
      return is("a named pipe (FIFO)");
    case S_IFDIR:
      return is("a folder");
    case S_IFSOCK:
      return is("a socket");
    default:
      return is("a device");
  }
}

[[noreturn]] void fail(const std::string& name, const std::string& problem) {
  throw std::runtime_error(name + ": " + problem);
}

std::string reason() { return std::generic_category().message(errno); }

// With the error's number where the machine lacks something: it is waited for.
[[noreturn]] void cannot_read(const std::string& name) {
  if (errno == EMFILE || errno == ENFILE || errno == ENOMEM) {
    throw std::system_error(errno, std::generic_category(), name + ": cannot be read");
  }
  fail(name, "cannot be read: " + reason());
}

}  // namespace

std::string not_regular(const std::filesystem::path& file) {
  struct stat info {};
  return ::stat(file.c_str(), &info) == 0 ? problem_of(info.st_mode) : "";
}

RegularFile::RegularFile(const std::filesystem::path& file) : name_(file.string()) {
  if (const std::string problem = not_regular(file); !problem.empty()) fail(name_, problem);
  descriptor_ = ::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
  if (descriptor_ < 0) cannot_read(name_);
  struct stat info {};
  const std::string problem = ::fstat(descriptor_, &info) == 0 ? problem_of(info.st_mode) : reason();
  if (problem.empty()) return;
  ::close(descriptor_);
  fail(name_, problem);
}

RegularFile::~RegularFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

std::size_t RegularFile::read(char* data, std::size_t size) {
  std::size_t total = 0;
  while (total < size) {
    const ssize_t count = ::read(descriptor_, data + total, size - total);
    if (count == 0) break;
    if (count > 0) {
      total += static_cast<std::size_t>(count);
    } else if (errno != EINTR) {
      cannot_read(name_);
    }
  }
  return total;
}

int RegularFile::release() { return std::exchange(descriptor_, -1); }

std::string text_of(const std::filesystem::path& file, std::size_t most) {
  RegularFile source(file);
  std::string text;
  for (std::size_t got = piece; got == piece && text.size() <= most;) {
    const std::size_t begin = text.size();
    text.resize(begin + piece);
    got = source.read(text.data() + begin, piece);
    text.resize(begin + got);
  }
  if (text.size() > most) fail(file.string(), "has more than " + std::to_string(most >> 20) + " MiB");
  return text;
}

}  // namespace files

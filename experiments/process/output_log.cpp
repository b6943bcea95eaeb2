#include "experiments/process/output_log.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

namespace process {
namespace {

constexpr std::size_t longest_tail = 1024;  // in which the last line is looked for
constexpr std::size_t longest_line = 200;   // of it that a sentence can bear

}  // namespace

OutputLog::OutputLog(const std::filesystem::path& path, std::size_t limit) : limit_(limit) {
  if (path.empty()) return;
  // Whoever reads a named pipe there and is slow loses the rest, and the game goes on.
  file_ = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_NONBLOCK | O_NOCTTY | O_CLOEXEC, 0644);
  if (file_ < 0) {
    throw std::system_error(errno, std::generic_category(), "cannot write " + path.string());
  }
}

OutputLog::OutputLog(OutputLog&& other) noexcept
    : file_(std::exchange(other.file_, -1)),
      tail_(std::move(other.tail_)),
      limit_(other.limit_),
      written_(other.written_),
      discarded_(other.discarded_) {}

OutputLog::~OutputLog() {
  if (file_ >= 0) ::close(file_);
}

void OutputLog::put(std::string_view text) {
  while (file_ >= 0 && !text.empty()) {
    const ssize_t count = ::write(file_, text.data(), text.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) {  // a full disk costs the log, not the game
      ::close(file_);
      file_ = -1;
      return;
    }
    text.remove_prefix(static_cast<std::size_t>(count));
  }
}

void OutputLog::write(std::string_view text) {
  tail_.append(text.substr(text.size() - std::min(text.size(), longest_tail)));
  if (tail_.size() > longest_tail) tail_.erase(0, tail_.size() - longest_tail);
  const std::size_t kept = std::min(text.size(), limit_ - written_);
  put(text.substr(0, kept));
  written_ += kept;
  if (kept == text.size()) return;
  if (discarded_ == 0)
    put("\n[output limit of " + std::to_string(limit_) + " bytes reached; the rest is discarded]\n");
  discarded_ += text.size() - kept;
}

std::string OutputLog::last_line() const {
  const std::size_t end = tail_.find_last_not_of(" \t\r\n");
  if (end == std::string::npos) return "";
  const std::size_t before = tail_.find_last_of("\r\n", end);
  const std::size_t begin = tail_.find_first_not_of(" \t", before == std::string::npos ? 0 : before + 1);
  std::string line = tail_.substr(begin, end + 1 - begin);
  // One line of a sentence: no escape sequences of a terminal, no half characters where it is cut.
  const auto control = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; };
  std::replace_if(line.begin(), line.end(), control, ' ');
  if (line.size() <= longest_line) return line;
  std::size_t cut = line.size() - longest_line;
  while (cut < line.size() && (static_cast<unsigned char>(line[cut]) & 0xC0U) == 0x80U) ++cut;
  return "..." + line.substr(cut);
}

}  // namespace process

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

OutputLog::OutputLog(const std::filesystem::path& path, std::size_t limit) : limit_(limit) {
  if (path.empty()) return;
  file_ = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (file_ < 0) {
    throw std::runtime_error("cannot write " + path.string() + ": " + std::generic_category().message(errno));
  }
}

OutputLog::OutputLog(OutputLog&& other) noexcept
    : file_(std::exchange(other.file_, -1)),
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
  const std::size_t kept = std::min(text.size(), limit_ - written_);
  put(text.substr(0, kept));
  written_ += kept;
  if (kept == text.size()) return;
  if (discarded_ == 0)
    put("\n[output limit of " + std::to_string(limit_) + " bytes reached; the rest is discarded]\n");
  discarded_ += text.size() - kept;
}

}  // namespace process

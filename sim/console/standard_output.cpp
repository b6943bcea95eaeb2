#include "sim/console/standard_output.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <iostream>
#include <mutex>
#include <streambuf>
#include <string_view>
#include <system_error>

#include "sim/console/printable.h"

namespace console {
namespace {

constexpr std::size_t buffered = 1 << 16;  // [bytes] ours: a table goes out in one piece
constexpr int signal_base = 128;
static_assert(nobody_reads == signal_base + SIGPIPE);

enum class Errors { Kept, Dropped };

/// Text on its way to a file descriptor.
class Printer final : public std::streambuf {
 public:
  Printer(int file, Errors errors)
      : file_(file), errors_(errors), by_line_(errors == Errors::Dropped || ::isatty(file) == 1) {}

  /// The first error; 0: none.
  int error() const { return error_; }

  /// Everything out, also half a character; and what only closing the file would tell.
  void finish() {
    put(text_.size());
    const int copy = ::dup(file_);  // a network file system says "disk full" when a file is closed
    if (copy >= 0 && ::close(copy) != 0 && errno != EINTR) fail(errno);
  }

 protected:
  int_type overflow(int_type letter) override {
    if (traits_type::eq_int_type(letter, traits_type::eof())) return traits_type::not_eof(letter);
    const char one = traits_type::to_char_type(letter);
    return xsputn(&one, 1) == 1 ? letter : traits_type::eof();
  }

  std::streamsize xsputn(const char* text, std::streamsize count) override {
    const std::lock_guard lock(mutex_);
    text_.append(text, static_cast<std::size_t>(count));
    const bool full = text_.size() >= buffered;
    if ((full || (by_line_ && text_.find('\n') != std::string::npos)) && !put_whole()) return 0;
    return count;
  }

  int sync() override {
    const std::lock_guard lock(mutex_);
    return put_whole() ? 0 : -1;
  }

 private:
  /// All but half a character at the end.
  bool put_whole() {
    put(text_.size() - unfinished(text_));
    return error_ == 0 || errors_ == Errors::Dropped;
  }

  void fail(int error) {
    if (error_ == 0) error_ = error;
  }

  std::string safe(std::string_view text) const {
    if (errors_ == Errors::Kept) return printable_lines(text);
    std::string result;
    constexpr std::string_view redraw = clear_line;
    for (std::size_t at = text.find(redraw); at != std::string_view::npos; at = text.find(redraw)) {
      result += printable_lines(text.substr(0, at));
      result += redraw;
      text.remove_prefix(at + redraw.size());
    }
    return result + printable_lines(text);
  }

  void put(std::size_t count) {
    const std::string ready = safe(std::string_view(text_).substr(0, count));
    text_.erase(0, count);
    std::string_view rest = ready;
    if (errors_ == Errors::Kept && error_ != 0) return;
    while (!rest.empty()) {
      const ssize_t written = ::write(file_, rest.data(), rest.size());
      if (written >= 0) {
        rest.remove_prefix(static_cast<std::size_t>(written));
      } else if (errno == EAGAIN && errors_ == Errors::Kept) {  // somebody made our terminal non-blocking
        pollfd ready_again{file_, POLLOUT, 0};
        ::poll(&ready_again, 1, -1);
      } else if (errno != EINTR) {
        fail(errno);
        return;
      }
    }
  }

  int file_;
  Errors errors_;
  bool by_line_;
  int error_ = 0;
  std::string text_;
  std::mutex mutex_;  // as of the usual buffer: threads may print
};

/// Descriptors 0 to 2 that are closed would be given to the next file that is opened, and what we print would
/// land in it. They get one that can be neither read nor written, each the wrong way round.
void occupy_standard_files() {
  for (const int file : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(file, F_GETFD) >= 0 || errno != EBADF) continue;
    ::open("/dev/null", file == STDIN_FILENO ? O_WRONLY : O_RDONLY);  // takes the lowest that is free
  }
}

}  // namespace

int run_program(const std::string& program, const std::function<int()>& main) {
  occupy_standard_files();
  std::signal(SIGPIPE, SIG_IGN);  // programs that are started get the usual handling back
  Printer out(STDOUT_FILENO, Errors::Kept);
  Printer errors(STDERR_FILENO, Errors::Dropped);
  std::streambuf* const usual_out = std::cout.rdbuf(&out);
  std::streambuf* const usual_errors = std::cerr.rdbuf(&errors);
  int code = main();
  std::cout.flush();
  out.finish();
  if (out.error() == EPIPE) {
    code = nobody_reads;
  } else if (out.error() != 0) {
    std::cerr << program << ": cannot write standard output: " << std::generic_category().message(out.error())
              << std::endl;
    code = cannot_print;
  }
  errors.finish();
  std::cout.rdbuf(usual_out);
  std::cerr.rdbuf(usual_errors);
  return code;
}

}  // namespace console

#include "sim/console/standard_output.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <iostream>

namespace console {
namespace {

/// Puts another file in the place of a descriptor while it lives.
class Instead {
 public:
  Instead(int file, int other) : file_(file), saved_(::dup(file)) { ::dup2(other, file); }
  Instead(const Instead&) = delete;
  Instead& operator=(const Instead&) = delete;
  ~Instead() {
    ::dup2(saved_, file_);
    ::close(saved_);
  }

 private:
  int file_;
  int saved_;
};

struct Pipe {
  Pipe() { EXPECT_EQ(::pipe2(ends.data(), O_NONBLOCK | O_CLOEXEC), 0); }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  ~Pipe() {
    for (const int end : ends) ::close(end);
  }
  std::string read() const {
    std::array<char, 4096> buffer;
    const ssize_t count = ::read(ends[0], buffer.data(), buffer.size());
    return {buffer.data(), static_cast<std::size_t>(std::max<ssize_t>(count, 0))};
  }
  std::array<int, 2> ends{};
};

struct Said {
  int code;
  std::string out;
  std::string errors;
};

/// Runs a program; its output goes to `file` if there is one.
Said run(const std::function<int()>& main, int file = -1) {
  const Pipe out;
  const Pipe errors;
  Said said{};
  {
    const Instead one(STDOUT_FILENO, file < 0 ? out.ends[1] : file);
    const Instead two(STDERR_FILENO, errors.ends[1]);
    said.code = run_program("program", main);
  }
  std::cout.clear();
  said.out = out.read();
  said.errors = errors.read();
  return said;
}

TEST(RunProgram, PrintsAndReturnsWhatTheProgramReturns) {
  const Said said = run([] {
    std::cout << "one " << 2 << "\n";
    std::cerr << "and three\n";
    return 11;
  });
  EXPECT_EQ(said.code, 11);
  EXPECT_EQ(said.out, "one 2\n");
  EXPECT_EQ(said.errors, "and three\n");
}

TEST(RunProgram, SaysInOneSentenceThatStandardOutputIsFull) {
  const int full = ::open("/dev/full", O_WRONLY | O_CLOEXEC);
  const Said said = run(
      [] {
        std::cout << "a table";
        return 0;
      },
      full);
  ::close(full);
  EXPECT_EQ(said.code, cannot_print);
  EXPECT_EQ(said.errors, "program: cannot write standard output: No space left on device\n");
}

TEST(RunProgram, GoesOnWhenStandardOutputIsFull) {
  const int full = ::open("/dev/full", O_WRONLY | O_CLOEXEC);
  bool ended = false;
  run(
      [&] {
        std::cout << "a line" << std::endl;
        EXPECT_FALSE(std::cout.good());
        std::cout << "another" << std::endl;
        ended = true;
        return 0;
      },
      full);
  ::close(full);
  EXPECT_TRUE(ended);
}

TEST(RunProgram, EndsQuietlyWhenNobodyReads) {
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe2(ends.data(), O_CLOEXEC), 0);
  ::close(ends[0]);
  const Said said = run(
      [] {
        std::cout << "a table" << std::endl;
        return 0;
      },
      ends[1]);
  ::close(ends[1]);
  EXPECT_EQ(said.code, nobody_reads);
  EXPECT_EQ(said.errors, "");
}

TEST(RunProgram, DropsWhatStandardErrorDoesNotTake) {
  const int full = ::open("/dev/full", O_WRONLY | O_CLOEXEC);
  int code = -1;
  {
    const Instead errors(STDERR_FILENO, full);
    code = run_program("program", [] {
      std::cerr << "progress" << std::endl;
      EXPECT_TRUE(std::cerr.good());
      return 3;
    });
  }
  ::close(full);
  EXPECT_EQ(code, 3);
}

TEST(RunProgram, PrintsNothingThatActsOnATerminal) {
  const Said said = run([] {
    std::cout << "name\x1B[2J\n\xE6" << std::flush << "\x97\xA5";  // a character in two pieces
    std::cerr << "\x1B]0;title\a" << clear_line << "progress";
    return 0;
  });
  EXPECT_EQ(said.out, "name\xEF\xBF\xBD[2J\n日");
  EXPECT_EQ(said.errors, "\xEF\xBF\xBD]0;title\xEF\xBF\xBD\r\033[Kprogress");
}

}  // namespace
}  // namespace console

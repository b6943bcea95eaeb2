#include "sim/wire/byte_file.h"

#include <fcntl.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <limits>
#include <stdexcept>
#include <system_error>

#include "sim/files/regular_file.h"
#include "sim/wire/output_error.h"

namespace wire {

namespace {

constexpr unsigned gzip_buffer = 1 << 17;  // [bytes] zlib's own 8 KiB costs a system call per few records

std::string reason() { return std::generic_category().message(errno); }

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

struct CloseGzip {
  void operator()(gzFile_s* file) const { gzclose(file); }
};
using Gzip = std::unique_ptr<gzFile_s, CloseGzip>;

std::string gzip_reason(gzFile file) {
  int code = Z_OK;
  const char* message = gzerror(file, &code);
  return code == Z_ERRNO ? reason() : std::string(message);
}

/// A file that is made, or emptied, to be written.
class Target {
 public:
  explicit Target(const std::filesystem::path& path) : path_(path) {}

  /// The descriptor, for whoever closes it.
  int open() {
    const int file =
        ::open(path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_NONBLOCK | O_NOCTTY | O_CLOEXEC, 0666);
    if (file < 0) {
      const std::string why = errno == ENXIO ? "nobody reads this named pipe (FIFO) or socket" : reason();
      throw OutputError(path_.string() + ": cannot be created: " + why);
    }
    ::fcntl(file, F_SETFL, ::fcntl(file, F_GETFL) & ~O_NONBLOCK);  // a slow reader is waited for
    return file;
  }

  [[noreturn]] void fail(const std::string& why) const {
    std::error_code ignored;
    const std::filesystem::path file = std::filesystem::canonical(path_, ignored);  // not a link to it
    if (std::filesystem::is_regular_file(file, ignored)) std::filesystem::remove(file, ignored);
    throw OutputError(path_.string() + ": cannot be written: " + why);
  }

 private:
  std::filesystem::path path_;
};

class PlainSink final : public ByteSink {
 public:
  explicit PlainSink(const std::filesystem::path& path)
      : target_(path), file_(::fdopen(target_.open(), "wb")) {
    if (!file_) target_.fail(reason());
  }
  void write(const char* data, std::size_t size) override {
    if (std::fwrite(data, 1, size, file_.get()) != size) target_.fail(reason());
  }
  void close() override {
    if (std::fclose(file_.release()) != 0) target_.fail(reason());
  }

 private:
  Target target_;
  File file_;
};

class GzipSink final : public ByteSink {
 public:
  explicit GzipSink(const std::filesystem::path& path)
      : target_(path), file_(gzdopen(target_.open(), "wb1")) {
    if (!file_) target_.fail(reason());
    gzbuffer(file_.get(), gzip_buffer);
  }
  void write(const char* data, std::size_t size) override {
    if (gzfwrite(data, 1, size, file_.get()) != size) target_.fail(gzip_reason(file_.get()));
  }
  void close() override {
    if (gzclose(file_.release()) != Z_OK) target_.fail(reason());
  }

 private:
  Target target_;
  Gzip file_;
};

class PlainSource final : public ByteSource {
 public:
  explicit PlainSource(const std::filesystem::path& path)
      : file_(::fdopen(files::RegularFile(path).release(), "rb")) {
    if (!file_) throw std::runtime_error(path.string() + ": cannot be read: " + reason());
  }
  std::size_t read(char* data, std::size_t size) override {
    const std::size_t count = std::fread(data, 1, size, file_.get());
    if (count < size && std::ferror(file_.get())) throw std::runtime_error("cannot be read: " + reason());
    return count;
  }
  bool cut() const override { return false; }

 private:
  File file_;
};

class GzipSource final : public ByteSource {
 public:
  explicit GzipSource(const std::filesystem::path& path)
      : file_(gzdopen(files::RegularFile(path).release(), "rb")) {
    if (!file_) throw std::runtime_error(path.string() + ": cannot be read: " + reason());
    gzbuffer(file_.get(), gzip_buffer);
    if (gzdirect(file_.get()))
      throw std::runtime_error(path.string() + ": is not gzip data, although its name ends in .gz");
  }
  std::size_t read(char* data, std::size_t size) override {
    std::size_t total = 0;
    while (total < size) {
      const std::size_t piece = std::min<std::size_t>(size - total, std::numeric_limits<int>::max());
      const int count = gzread(file_.get(), data + total, static_cast<unsigned>(piece));
      if (count < 0) throw std::runtime_error("gzip data damaged: " + gzip_reason(file_.get()));
      if (count == 0) break;
      total += static_cast<std::size_t>(count);
    }
    int code = Z_OK;
    gzerror(file_.get(), &code);
    cut_ = code == Z_BUF_ERROR;
    return total;
  }
  bool cut() const override { return cut_; }

 private:
  Gzip file_;
  bool cut_ = false;
};

}  // namespace

std::unique_ptr<ByteSink> open_sink(const std::filesystem::path& path) {
  if (path.extension() == ".gz") return std::make_unique<GzipSink>(path);
  return std::make_unique<PlainSink>(path);
}

std::unique_ptr<ByteSource> open_source(const std::filesystem::path& path) {
  if (path.extension() == ".gz") return std::make_unique<GzipSource>(path);
  return std::make_unique<PlainSource>(path);
}

}  // namespace wire

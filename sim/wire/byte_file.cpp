#include "sim/wire/byte_file.h"

#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <limits>
#include <system_error>
#include <utility>

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

[[noreturn]] void fail(const std::string& path, const std::string& what) {
  throw std::runtime_error(path + ": " + what);
}

std::string gzip_reason(gzFile file) {
  int code = Z_OK;
  const char* message = gzerror(file, &code);
  return code == Z_ERRNO ? reason() : std::string(message);
}

class PlainSink final : public ByteSink {
 public:
  explicit PlainSink(std::string path) : path_(std::move(path)), file_(std::fopen(path_.c_str(), "wb")) {
    if (!file_) fail(path_, "cannot be created: " + reason());
  }
  void write(const char* data, std::size_t size) override {
    if (std::fwrite(data, 1, size, file_.get()) != size) fail(path_, "cannot be written: " + reason());
  }
  void close() override {
    if (std::fclose(file_.release()) != 0) fail(path_, "cannot be written: " + reason());
  }

 private:
  std::string path_;
  File file_;
};

class GzipSink final : public ByteSink {
 public:
  explicit GzipSink(std::string path) : path_(std::move(path)), file_(gzopen(path_.c_str(), "wb1")) {
    if (!file_) fail(path_, "cannot be created: " + reason());
    gzbuffer(file_.get(), gzip_buffer);
  }
  void write(const char* data, std::size_t size) override {
    if (gzfwrite(data, 1, size, file_.get()) != size)
      fail(path_, "cannot be written: " + gzip_reason(file_.get()));
  }
  void close() override {
    if (gzclose(file_.release()) != Z_OK) fail(path_, "cannot be written: " + reason());
  }

 private:
  std::string path_;
  Gzip file_;
};

class PlainSource final : public ByteSource {
 public:
  explicit PlainSource(const std::string& path) : file_(std::fopen(path.c_str(), "rb")) {
    if (!file_) fail(path, "cannot be opened: " + reason());
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
  explicit GzipSource(const std::string& path) : file_(gzopen(path.c_str(), "rb")) {
    if (!file_) fail(path, "cannot be opened: " + reason());
    gzbuffer(file_.get(), gzip_buffer);
    if (gzdirect(file_.get())) fail(path, "is not gzip data, although its name ends in .gz");
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
  if (path.extension() == ".gz") return std::make_unique<GzipSink>(path.string());
  return std::make_unique<PlainSink>(path.string());
}

std::unique_ptr<ByteSource> open_source(const std::filesystem::path& path) {
  if (path.extension() == ".gz") return std::make_unique<GzipSource>(path.string());
  return std::make_unique<PlainSource>(path.string());
}

}  // namespace wire

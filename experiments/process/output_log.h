#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace process {

/// A file that takes at most so many bytes; what comes later is counted and thrown away.
///
/// A program that writes without end must not fill the disk, and must not block on a full pipe either.
class OutputLog {
 public:
  /// @param path  empty: everything is thrown away
  /// @throws std::runtime_error when the file cannot be made
  OutputLog(const std::filesystem::path& path, std::size_t limit);
  OutputLog(OutputLog&& other) noexcept;
  OutputLog(const OutputLog&) = delete;
  OutputLog& operator=(OutputLog&&) = delete;
  OutputLog& operator=(const OutputLog&) = delete;
  ~OutputLog();

  void write(std::string_view text);

  std::size_t written() const { return written_; }
  std::size_t discarded() const { return discarded_; }

  /// The last line that is not blank, shortened; empty when nothing was printed. Known without a file, too.
  std::string last_line() const;

 private:
  void put(std::string_view text);

  int file_ = -1;
  std::string tail_;  ///< the last bytes
  std::size_t limit_;
  std::size_t written_ = 0;
  std::size_t discarded_ = 0;
};

}  // namespace process

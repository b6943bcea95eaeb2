#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <string_view>
#include <variant>

namespace record {

/// XXH3-128 of some bytes, 32 hexadecimal digits.
std::string checksum(std::string_view bytes);

/// XXH3-128 of a file's bytes.
///
/// @param most  [bytes] that are read, for files of others: one with holes costs nothing to make
/// @throws std::runtime_error naming the file when it cannot be read, is no regular file or has more
std::string checksum_of_file(const std::filesystem::path& file,
                             std::int64_t most = std::numeric_limits<std::int64_t>::max());

/// A column of a row as SQLite keeps it: NULL, INTEGER, REAL or TEXT.
using Value = std::variant<std::monostate, std::int64_t, double, std::string>;

/// The checksum of a row: of the table's name and then of every column in the order of the table, each as its
/// length in bytes, a colon and its text. Integers are decimal, reals as printf's %.17g, NULL is "-" alone.
/// README.md says it for those who compute it again.
class RowChecksum {
 public:
  explicit RowChecksum(std::string_view table) { add_text(table); }
  void add(const Value& value);
  std::string digits() const { return checksum(bytes_); }

 private:
  void add_text(std::string_view text);
  std::string bytes_;
};

}  // namespace record

#pragma once

#include <cstdint>
#include <string>

namespace record {

/// A file of a result folder as it was when it was written to its end.
struct KeptFile {
  std::string path;  ///< seen from the result folder, with /
  std::int64_t size = 0;
  std::string checksum;  ///< XXH3-128 of its bytes
  bool operator==(const KeptFile&) const = default;
};

}  // namespace record

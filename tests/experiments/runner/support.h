#pragma once

#include <stdlib.h>

#include <filesystem>
#include <stdexcept>
#include <string>

#include "experiments/schedule/design.h"

namespace runner {

/// A folder that goes away with the test; in memory where there is such a place, since every row of a ledger
/// waits for the disk.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = "/dev/shm/runner-test-XXXXXX";
    if (::mkdtemp(name.data()) == nullptr) {
      name = (std::filesystem::temp_directory_path() / "runner-test-XXXXXX").string();
      if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("mkdtemp failed");
    }
    path_ = std::filesystem::canonical(name);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// Two conditions; the teams' programs exist but are never started by the fake worker.
inline schedule::Design small_design(int pairs) {
  schedule::Design design;
  design.name = "small";
  design.seed = 11;
  design.pairs = pairs;
  const record::TeamConfig a{.name = "ours", .command = {"true"}};
  record::TeamConfig b{.name = "theirs", .command = {"true"}};
  design.conditions.push_back({"equal", a, b});
  b.speed_factor = 0.5;
  design.conditions.push_back({"slow", a, b});
  return design;
}

}  // namespace runner

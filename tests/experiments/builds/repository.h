#pragma once

#include <stdlib.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include "experiments/process/filter.h"

namespace builds {

/// A folder with a git repository `team` of two commits, which goes away with the test.
///
/// `main` (also tagged v1) holds team.sh that prints one, `feature` one that prints two; their build copies
/// it to bin/team.
class Repository {
 public:
  Repository() {
    std::string name = (std::filesystem::temp_directory_path() / "builds-test-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("mkdtemp failed");
    folder_ = std::filesystem::canonical(name);
    std::filesystem::create_directories(path());
    shell("git init -q -b main");
    write("echo one");
    shell("git add -A && " + identity + " commit -qm one && git tag v1 && git checkout -q -b feature");
    write("echo two");
    shell("git add -A && " + identity + " commit -qm two && git checkout -q main");
  }
  Repository(const Repository&) = delete;
  Repository& operator=(const Repository&) = delete;
  ~Repository() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }

  std::filesystem::path path() const { return folder_ / "team"; }
  const std::filesystem::path& folder() const { return folder_; }

  void write(const std::string& line) const {
    std::ofstream(path() / "team.sh") << "#!/bin/sh\n" << line << "\n";
    shell("chmod +x team.sh");
  }

  /// Runs it in the repository.
  void shell(const std::string& line) const {
    const process::Filtered found =
        process::filter({.arguments = {"/bin/sh", "-c", line}, .directory = path()});
    if (!found.well) throw std::runtime_error("failed: " + line + ": " + found.problem);
  }

  const std::string identity = "git -c user.name=test -c user.email=test@example.org";

 private:
  std::filesystem::path folder_;
};

}  // namespace builds

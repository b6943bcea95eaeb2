#include "experiments/runner/scratch.h"

#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <system_error>

#include "experiments/process/tree.h"
#include "experiments/process/whole_file.h"
#include "experiments/record/ledger.h"
#include "sim/files/regular_file.h"

namespace runner {
namespace {

namespace fs = std::filesystem;

constexpr const char* prefix = "matchday-run-";

/// Whether a name that stood in a file is one that only we give, and the folder is ours:
/// nothing else is removed.
bool is_ours(const fs::path& path) {
  struct stat info {};
  return path.parent_path() == fs::temp_directory_path() && path.filename().string().starts_with(prefix) &&
         ::lstat(path.c_str(), &info) == 0 && S_ISDIR(info.st_mode) && info.st_uid == ::geteuid();
}

}  // namespace

Scratch::Scratch(fs::path note) : note_(std::move(note)) {
  std::string before;
  if (files::not_regular(note_).empty()) {
    std::ifstream stream(note_);
    if (std::getline(stream, before) && is_ours(before)) process::remove_tree(before);
  }
  std::string name = fs::temp_directory_path().string() + "/";
  name += prefix;
  name += "XXXXXX";
  if (::mkdtemp(name.data()) == nullptr) {  // makes it with mode 0700
    throw record::StorageError("cannot make the folder " + name +
                               " for temporary files: " + std::generic_category().message(errno));
  }
  path_ = name;
  try {
    process::write_whole(note_, path_.string() + "\n");
  } catch (const std::system_error&) {  // then a killed run leaves its folder, no more
  }
}

Scratch::~Scratch() {
  std::error_code ignored;
  process::remove_tree(path_);
  fs::remove(note_, ignored);
}

}  // namespace runner

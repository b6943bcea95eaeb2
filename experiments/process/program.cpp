#include "experiments/process/program.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <string_view>
#include <system_error>

namespace process {
namespace {

namespace fs = std::filesystem;

bool is_program(const fs::path& path) {
  struct stat status {};
  return ::stat(path.c_str(), &status) == 0 && S_ISREG(status.st_mode) && ::access(path.c_str(), X_OK) == 0;
}

fs::path own_folder() {
  std::error_code ignored;
  const fs::path own = fs::read_symlink("/proc/self/exe", ignored);
  return own.parent_path();
}

}  // namespace

bool is_shortage(int cause) {
  return cause == EAGAIN || cause == ENOMEM || cause == EMFILE || cause == ENFILE;
}

fs::path find_program(const std::string& name, const fs::path& directory) {
  if (name.empty()) throw StartError("the command of a program is empty");

  if (name.find('/') != std::string::npos) {
    std::error_code error;
    const fs::path path = fs::absolute(directory / name, error);
    const std::string where = directory.empty() ? "" : " in " + directory.string();
    if (!fs::exists(path, error)) throw StartError("program '" + name + "' does not exist" + where);
    if (!is_program(path))
      throw StartError(
          "program '" + name + "' is not an executable file" + where +
          (fs::is_regular_file(path, error)
               ? "; make it one with chmod +x, or begin the command with its interpreter, as python3"
               : ""));
    return path;
  }

  const fs::path beside = own_folder() / name;
  if (is_program(beside)) return beside;

  const char* variable = std::getenv("PATH");
  std::string_view rest = variable != nullptr ? variable : "/usr/local/bin:/usr/bin:/bin";
  while (!rest.empty()) {
    const std::size_t end = rest.find(':');
    const std::string_view folder = rest.substr(0, end);
    rest = end == std::string_view::npos ? std::string_view{} : rest.substr(end + 1);
    if (folder.empty()) continue;
    const fs::path candidate = fs::absolute(fs::path(folder)) / name;
    if (is_program(candidate)) return candidate;
  }
  std::error_code ignored;
  const bool here = fs::is_regular_file(directory / name, ignored);
  throw StartError("program '" + name + "' found neither in " + own_folder().string() + " nor in PATH" +
                   (here ? "; write ./" + name + " for the file of that name" +
                               (directory.empty() ? " in this folder" : " in " + directory.string())
                         : ""));
}

}  // namespace process

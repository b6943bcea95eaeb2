#include "experiments/process/proc.h"

#include <dirent.h>

#include <algorithm>
#include <memory>
#include <string_view>

namespace process {

std::vector<pid_t> numbers_in(const std::string& folder) {
  struct Close {
    void operator()(DIR* directory) const { ::closedir(directory); }
  };
  std::vector<pid_t> numbers;
  const std::unique_ptr<DIR, Close> directory(::opendir(folder.c_str()));
  if (!directory) return numbers;
  while (const dirent* entry = ::readdir(directory.get())) {
    const std::string_view name = entry->d_name;
    const bool digits =
        std::all_of(name.begin(), name.end(), [](char letter) { return letter >= '0' && letter <= '9'; });
    if (digits) numbers.push_back(static_cast<pid_t>(std::stol(std::string(name))));
  }
  return numbers;
}

std::string folder_of(pid_t process) { return "/proc/" + std::to_string(process); }

}  // namespace process

#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>

#include "experiments/process/child.h"
#include "experiments/process/family.h"

namespace process {
namespace {

/// With the children it has waited for, if wanted.
std::optional<Usage> usage_of(pid_t process, bool with_children) {
  const std::string folder = "/proc/" + std::to_string(process);
  std::ifstream status(folder + "/status");
  Usage result;
  bool found = false;
  for (std::string line; std::getline(status, line);) {
    if (line.rfind("VmHWM:", 0) != 0) continue;
    std::istringstream(line.substr(6)) >> result.peak_memory;
    result.peak_memory *= 1024;  // proc(5): "kB", meaning KiB
    found = true;
  }
  if (!found) return std::nullopt;

  // Fields 14 to 17, utime, stime, cutime and cstime, in clock ticks; the name in field 2 may hold anything,
  // so start behind it.
  std::ifstream stat(folder + "/stat");
  std::string text;
  std::getline(stat, text);
  const std::size_t name_end = text.rfind(')');
  if (name_end == std::string::npos) return std::nullopt;
  std::istringstream fields(text.substr(name_end + 1));
  std::string skipped;
  for (int field = 3; field < 14; ++field) fields >> skipped;
  double user = 0;
  double system = 0;
  double childrens_user = 0;
  double childrens_system = 0;
  fields >> user >> system >> childrens_user >> childrens_system;
  const auto clock_ticks = static_cast<double>(::sysconf(_SC_CLK_TCK));
  result.user_seconds = (user + (with_children ? childrens_user : 0)) / clock_ticks;
  result.system_seconds = (system + (with_children ? childrens_system : 0)) / clock_ticks;
  return result;
}

}  // namespace

std::optional<Usage> usage(pid_t process) { return usage_of(process, false); }

std::optional<Usage> family_usage(pid_t process) {
  std::optional<Usage> sum;
  for (const pid_t member : family_of(process)) {
    const std::optional<Usage> its = usage_of(member, true);
    if (!its) continue;
    if (!sum) sum.emplace();
    sum->user_seconds += its->user_seconds;
    sum->system_seconds += its->system_seconds;
    sum->peak_memory = std::max(sum->peak_memory, its->peak_memory);
  }
  return sum;
}

}  // namespace process

#pragma once

#include <sys/types.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace fakes {

/// The living processes of a group. Dead ones may still wait for init to reap them; they do not count.
inline std::vector<pid_t> living_members(pid_t group) {
  std::vector<pid_t> result;
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    const std::string number = entry.path().filename().string();
    if (!std::all_of(number.begin(), number.end(), [](unsigned char c) { return std::isdigit(c) != 0; }))
      continue;
    std::ifstream stat(entry.path() / "stat");
    std::string text;
    std::getline(stat, text);
    const std::size_t name_end = text.rfind(')');  // the name may hold spaces and brackets
    if (name_end == std::string::npos) continue;
    std::istringstream fields(text.substr(name_end + 1));
    std::string state;
    pid_t parent = 0;
    pid_t its_group = 0;
    fields >> state >> parent >> its_group;
    if (its_group == group && state != "Z" && state != "X")
      result.push_back(static_cast<pid_t>(std::stol(number)));
  }
  return result;
}

/// Whether the group has no living member, now or soon.
inline bool is_gone(pid_t group) {
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::seconds{20};  // for a loaded machine; KILL needs microseconds
  while (Clock::now() < end) {
    if (living_members(group).empty()) return true;
    ::usleep(2000);
  }
  return false;
}

}  // namespace fakes

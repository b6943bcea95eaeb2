#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

// Reading /proc.
namespace process {

/// The names in a folder that are numbers, as those of processes, threads and descriptors are; nothing when
/// it cannot be read.
std::vector<pid_t> numbers_in(const std::string& folder);

/// "/proc/NUMBER"
std::string folder_of(pid_t process);

}  // namespace process

#pragma once

#include <sys/types.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>

namespace process {

/// What processes hold that is neither resident in them nor in any file with a name.
struct Held {
  std::int64_t memory = 0;  ///< [bytes] of memory files, less what is mapped: that is resident
  std::int64_t disk = 0;    ///< [bytes] of files on the folder's disk that are open and have no name any more
  bool whole = true;        ///< false: there are more open files and mounts than `most_held_entries`
};

/// Ours: many times what a team has open, and looked through in some 20 ms.
inline constexpr std::size_t most_held_entries = 10'000;

/// Whether file systems in memory that only these processes see count as well: those of their cell, and what
/// they have mounted themselves. Outside of a cell one that does not answer (FUSE) would hold us up.
enum class OwnMounts { Ignored, Counted };

/// Looks through their open files, those of threads with a table of their own included. Never waits for a
/// file system.
///
/// @param folder  whose disk is meant; empty: none
Held held_by(std::span<const pid_t> processes, const std::filesystem::path& folder, OwnMounts mounts);

}  // namespace process

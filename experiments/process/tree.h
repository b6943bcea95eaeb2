#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>

// Folders in which somebody else's program has written: whatever lies there, links are never followed,
// nothing is opened that could block, and neither depth nor number can exhaust us.
namespace process {

/// What a folder takes.
struct TreeSize {
  std::int64_t bytes = 0;   ///< of files on the disk: without holes, with what is set aside for them
  std::int64_t length = 0;  ///< [bytes] of files as they say: with holes
  std::size_t entries = 0;  ///< files, folders and everything else
  bool whole = true;        ///< false: there is more, beyond the bounds
};

/// How far a look at a folder goes; ours: many times what a log needs, and looked
/// through in some milliseconds.
struct TreeBounds {
  std::size_t entries = 10'000;
  int depth = 32;
};

/// Nothing when there is no such folder.
TreeSize tree_size(const std::filesystem::path& folder, const TreeBounds& bounds = {});

/// Removes a file or a folder with all that is in it, as far as we may; also folders without rights of their
/// owner, and deeper than a path can be long.
void remove_tree(const std::filesystem::path& path);

}  // namespace process

#pragma once

#include <filesystem>
#include <string_view>

namespace process {

/// Writes a file so that nobody ever reads half of it: under another name beside it, then renamed over what
/// was there. On failure what was there is still there, and nothing else.
///
/// @throws std::system_error naming the file and the cause, as "FILE: cannot be written:
///         No space left on device"
void write_whole(const std::filesystem::path& file, std::string_view text);

}  // namespace process

#pragma once

#include <cstdint>
#include <filesystem>

namespace runner {

/// Bytes that we may still write on the disk of that folder; the largest number when it cannot be asked, so
/// that a strange file system does not stop a run.
std::int64_t free_bytes(const std::filesystem::path& folder);

/// Whether the folder is on a file system that processes of several machines, or of none, may share: there a
/// ledger has no write-ahead log. Also when it cannot be asked.
bool is_remote(const std::filesystem::path& folder);

/// The same of statfs's f_type.
bool is_remote_type(std::uint32_t type);

/// Bytes of all files below a folder; by length; links are not followed.
std::int64_t size_of(const std::filesystem::path& folder);

}  // namespace runner

#include "experiments/runner/disk.h"

#include <sys/vfs.h>

#include <algorithm>
#include <array>
#include <limits>

#include "experiments/process/tree.h"

namespace runner {

namespace fs = std::filesystem;

std::int64_t free_bytes(const fs::path& folder) {
  std::error_code error;
  const fs::space_info space = fs::space(folder, error);
  constexpr auto most = std::numeric_limits<std::int64_t>::max();
  if (error || space.available > static_cast<std::uintmax_t>(most)) return most;
  return static_cast<std::int64_t>(space.available);
}

bool is_remote_type(std::uint32_t type) {
  // statfs(2), "Filesystem types", and of those it does not list the sources of Linux.
  constexpr std::array<std::uint32_t, 17> remote = {
      0x00006969,  // NFS
      0x0000517B,  // SMB
      0xFE534D42,  // SMB2
      0xFF534D42,  // CIFS
      0x65735546,  // FUSE, as sshfs
      0x01021997,  // 9P
      0x00C36400,  // Ceph
      0x5346414F,  // OpenAFS
      0x6B414653,  // kAFS
      0x73757245,  // Coda
      0x0000564C,  // NCP
      0x0BD00BD0,  // Lustre
      0x47504653,  // GPFS
      0x7461636F,  // OCFS2, shared disks
      0x01161970,  // GFS2, shared disks
      0x786F4256,  // VirtualBox's shared folders
      0xBACBACBC,  // VMware's
  };
  return std::find(remote.begin(), remote.end(), type) != remote.end();
}

bool is_remote(const fs::path& folder) {
  struct statfs info {};
  return ::statfs(folder.c_str(), &info) != 0 || is_remote_type(static_cast<std::uint32_t>(info.f_type));
}

std::int64_t size_of(const fs::path& folder) {
  constexpr process::TreeBounds bounds{.entries = 1'000'000,
                                       .depth = 256};  // ours: a team makes 10,000 at most
  return process::tree_size(folder, bounds).length;
}

}  // namespace runner

#include "experiments/process/held.h"

#include <dirent.h>
#include <fcntl.h>
#include <linux/kcmp.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <sys/syscall.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <memory>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <utility>

#include "experiments/process/proc.h"

namespace process {
namespace {

constexpr std::int64_t block = 512;  // [bytes] of stx_blocks, statx(2)

/// What is known without asking the file system: a dead server must not hold us up.
std::optional<struct statx> known_of(int folder, const char* name) {
  struct statx status {};
  constexpr unsigned wanted = STATX_TYPE | STATX_NLINK | STATX_INO | STATX_BLOCKS;
  if (::statx(folder, name, AT_STATX_DONT_SYNC | AT_NO_AUTOMOUNT, wanted, &status) != 0) return std::nullopt;
  return status;
}

dev_t device_of(const struct statx& status) { return makedev(status.stx_dev_major, status.stx_dev_minor); }

std::optional<dev_t> device_of(const char* path) {
  const auto status = known_of(AT_FDCWD, path);
  return status ? std::optional(device_of(*status)) : std::nullopt;
}

/// Where all files of memfd_create(2) are.
std::optional<dev_t> device_of_memory_files() {
  const int file = ::memfd_create("matchday", MFD_CLOEXEC);
  if (file < 0) return std::nullopt;
  struct stat status {};
  const bool known = ::fstat(file, &status) == 0;
  ::close(file);
  return known ? std::optional(status.st_dev) : std::nullopt;
}

/// "a b" of "a\040b", as /proc writes paths.
std::string unescaped(const std::string& text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\\' && i + 3 < text.size()) {
      result += static_cast<char>(std::stoi(text.substr(i + 1, 3), nullptr, 8));
      i += 3;
    } else {
      result += text[i];
    }
  }
  return result;
}

/// [bytes] of memory files that are mapped and touched.
std::int64_t mapped_memory_files(pid_t process) {
  const std::string tasks = folder_of(process) + "/task";
  for (const pid_t thread : numbers_in(tasks)) {  // the first one knows, unless it has ended
    std::ifstream stream(tasks + "/" + std::to_string(thread) + "/status");
    for (std::string line; std::getline(stream, line);) {
      if (line.starts_with("RssShmem:")) return std::stoll(line.substr(9)) * 1024;
    }
  }
  return 0;
}

class Look {
 public:
  Look(const std::filesystem::path& folder, OwnMounts mounts) : mounts_(mounts) {
    static const std::optional<dev_t> memory_files = device_of_memory_files();
    if (memory_files) memory_.insert(*memory_files);
    if (const auto shared = device_of("/dev/shm")) memory_.insert(*shared);
    if (!folder.empty()) disk_ = device_of(folder.c_str());
    if (const auto own = known_of(AT_FDCWD, "/proc/self/ns/mnt")) seen_spaces_.insert(own->stx_ino);
  }

  /// False when there are too many entries.
  bool add(pid_t process) {
    if (mounts_ == OwnMounts::Counted) add_mounts(process);
    add_files(process);
    return entries_ <= most_held_entries;
  }

  std::int64_t memory() const { return memory_bytes_; }
  std::int64_t disk() const { return disk_bytes_; }

 private:
  void add_mounts(pid_t process) {
    const auto space = known_of(AT_FDCWD, (folder_of(process) + "/ns/mnt").c_str());
    if (!space || !seen_spaces_.insert(space->stx_ino).second) return;
    std::ifstream stream(folder_of(process) + "/mountinfo");
    for (std::string line; std::getline(stream, line) && ++entries_ <= most_held_entries;) {
      // proc(5): "36 35 98:0 /root /place rw,noatime shared:1 - tmpfs source rw"
      std::istringstream words(line);
      std::string number, parent, device, root, place, options;
      words >> number >> parent >> device >> root >> place >> options;
      if (line.find(" - tmpfs ") == std::string::npos || !options.starts_with("rw")) continue;
      const std::string path = folder_of(process) + "/root" + unescaped(place);
      const auto status = known_of(AT_FDCWD, path.c_str());
      if (!status) continue;
      const std::string there =
          std::to_string(status->stx_dev_major) + ":" + std::to_string(status->stx_dev_minor);
      if (there != device || !own_mounts_.insert(device_of(*status)).second) continue;
      struct statvfs size {};
      if (::statvfs(path.c_str(), &size) != 0) continue;
      memory_bytes_ += static_cast<std::int64_t>((size.f_blocks - size.f_bfree) * size.f_frsize);
    }
  }

  void add_files(pid_t process) {
    const std::string tasks = folder_of(process) + "/task";
    pid_t first = 0;  // with a table of open files of its own
    pid_t last = 0;
    for (const pid_t thread : numbers_in(tasks)) {
      if (entries_ > most_held_entries) return;
      if (shares_files(first, thread) || (last != first && shares_files(last, thread))) continue;
      if (!add_table(tasks + "/" + std::to_string(thread) + "/fd")) continue;
      last = thread;
      if (first == 0) first = thread;
    }
  }

  /// Where nobody may say so, it is what all but odd programs do.
  static bool shares_files(pid_t one, pid_t other) {
    if (one == 0) return false;
    const long result = ::syscall(SYS_kcmp, one, other, KCMP_FILES, 0, 0);
    return result == 0 || (result < 0 && errno != ESRCH);
  }

  /// False when there is nothing in it, as of a thread that has ended.
  bool add_table(const std::string& folder) {
    struct Close {
      void operator()(DIR* directory) const { ::closedir(directory); }
    };
    const std::unique_ptr<DIR, Close> directory(::opendir(folder.c_str()));
    if (!directory) return false;
    bool any = false;
    while (const dirent* entry = ::readdir(directory.get())) {
      if (entry->d_name[0] == '.') continue;
      any = true;
      if (++entries_ > most_held_entries) break;
      if (const auto status = known_of(::dirfd(directory.get()), entry->d_name)) add_file(*status);
    }
    return any;
  }

  void add_file(const struct statx& status) {
    if (!S_ISREG(status.stx_mode) || status.stx_nlink > 0) return;
    const dev_t device = device_of(status);
    const bool on_disk = disk_ && device == *disk_;
    const bool in_memory = memory_.contains(device) && !own_mounts_.contains(device);
    if ((!on_disk && !in_memory) || !files_.emplace(device, status.stx_ino).second) return;
    (on_disk ? disk_bytes_ : memory_bytes_) += static_cast<std::int64_t>(status.stx_blocks) * block;
  }

  OwnMounts mounts_;
  std::set<dev_t> memory_;                           // file systems whose files are in memory
  std::optional<dev_t> disk_;                        // of the folder
  std::set<std::uint64_t> seen_spaces_;              // mount namespaces
  std::set<dev_t> own_mounts_;                       // of those, counted as a whole
  std::set<std::pair<dev_t, std::uint64_t>> files_;  // counted
  std::size_t entries_ = 0;
  std::int64_t memory_bytes_ = 0;
  std::int64_t disk_bytes_ = 0;
};

}  // namespace

Held held_by(std::span<const pid_t> processes, const std::filesystem::path& folder, OwnMounts mounts) {
  Look look(folder, mounts);
  Held held;
  for (const pid_t process : processes) {
    if (look.add(process)) continue;
    held.whole = false;
    break;
  }
  held.disk = look.disk();
  held.memory = look.memory();
  if (held.memory > 0) {
    for (const pid_t process : processes) held.memory -= mapped_memory_files(process);
  }
  held.memory = std::max(held.memory, std::int64_t{0});
  return held;
}

}  // namespace process

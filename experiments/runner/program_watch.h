#pragma once

#include <sys/inotify.h>
#include <sys/stat.h>

#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "experiments/runner/program_files.h"

namespace runner {

/// What happened to a program while an experiment ran.
struct ProgramChange {
  std::filesystem::path file;  ///< as the command names it
  /// It is what it was, but was something else meanwhile, or may have been: it was written into, or its name was
  /// another file's. One file put in place of another with the same content in one step (rename) is no change.
  bool restored = false;
};

/// What follows from it.
std::string sentence(const ProgramChange& change);

/// Notices that a program of the experiment was changed while the experiment runs, also for a moment only.
///
/// The kernel tells of everything that happens to the file and to the names that lead to it, folders and links
/// (inotify). Where it cannot, size, inode and times are compared. The file is read again only when there is
/// something new.
class ProgramWatch {
 public:
  explicit ProgramWatch(std::span<const ProgramFile> files);
  ProgramWatch(const ProgramWatch&) = delete;
  ProgramWatch& operator=(const ProgramWatch&) = delete;
  ~ProgramWatch();

  /// The first change since the last call; nothing while all is well.
  std::optional<ProgramChange> changed();

 private:
  struct Entry {
    std::filesystem::path name;
    std::string hash;
    struct stat seen {};
    int replaced = 0;      ///< by rename, since the last look
    bool touched = false;  ///< in any other way
    bool unsure = false;   ///< there were more events than the kernel keeps
  };
  void watch(std::size_t entry);
  void add(const std::filesystem::path& path, const std::string& name, std::size_t entry);
  void listen();
  void note(const inotify_event& event, const std::string& name);

  std::vector<Entry> entries_;
  int events_ = -1;  ///< inotify; -1: the system gives none
  /// What a watch is for: a name in a folder, or the file itself (no name).
  std::multimap<std::pair<int, std::string>, std::size_t> watches_;
};

}  // namespace runner

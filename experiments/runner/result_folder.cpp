#include "experiments/runner/result_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <system_error>
#include <thread>

#include "experiments/process/tree.h"
#include "experiments/record/ledger.h"

namespace runner {

namespace fs = std::filesystem;

constexpr std::chrono::seconds patience{1};  // KILL takes milliseconds

ResultFolder::ResultFolder(const fs::path& path) {
  const auto fail = [&path](const std::string& problem, int error) {
    throw record::StorageError("result folder " + path.string() + ": " + problem + ": " +
                               std::generic_category().message(error));
  };
  std::error_code error;
  fs::create_directories(path, error);
  if (error) fail("cannot be made", error.value());
  path_ = fs::canonical(path);
  check_links();
  lock_ = ::open(path_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (lock_ < 0) fail("cannot be opened", errno);
  // A run that has just been killed holds it until the last process it was about to start is gone, too.
  int reason = 0;
  for (const auto until = std::chrono::steady_clock::now() + patience;;) {
    if (::flock(lock_, LOCK_EX | LOCK_NB) == 0) return;
    reason = errno;
    if (reason != EWOULDBLOCK || std::chrono::steady_clock::now() > until) break;
    std::this_thread::sleep_for(std::chrono::milliseconds{10});
  }
  ::close(lock_);
  if (reason != EWOULDBLOCK) fail("cannot be locked", reason);
  throw record::FolderTaken("result folder " + path.string() +
                            ": another run is writing there; wait until it has ended, or give another --out");
}

ResultFolder::~ResultFolder() { ::close(lock_); }

fs::path ResultFolder::game(const std::string& id, int attempt) const {
  return path_ / "games" / id / std::to_string(attempt);
}

namespace {

void reject_link(const fs::path& path) {
  std::error_code ignored;
  const fs::file_type type = fs::symlink_status(path, ignored).type();
  switch (type) {
    case fs::file_type::none:
    case fs::file_type::not_found:
    case fs::file_type::regular:
    case fs::file_type::directory:
      return;
    default:
      throw record::StorageError(
          path.string() + ": is " + (type == fs::file_type::symlink ? "a link" : "neither file nor folder") +
          ", and a run writes into its own folder only; remove it, or give another --out");
  }
}

/// Of a folder's entries, and of theirs to that depth.
void reject_links_in(const fs::path& folder, int depth) {
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    reject_link(entry->path());
    std::error_code ignored;
    if (depth > 1 && entry->is_directory(ignored)) reject_links_in(entry->path(), depth - 1);
  }
}

}  // namespace

void ResultFolder::check_links() const {
  reject_links_in(path_, 1);
  reject_links_in(path_ / "games", 2);  // games/<id>/<attempt>; what is in there is the teams'
  reject_links_in(path_ / "audits", 1);
  reject_links_in(path_ / "preflight", 1);
}

void ResultFolder::check_links(const fs::path& below) const {
  fs::path path = path_;
  for (const fs::path& part : below.lexically_relative(path_)) reject_link(path /= part);
}

void ResultFolder::forget_game(const std::string& id, int attempt) const {
  std::error_code ignored;  // a leftover file is no reason to end a night
  process::remove_tree(game(id, attempt));
  fs::remove(path_ / "games" / id, ignored);  // these two only when they are empty
  fs::remove(path_ / "games", ignored);
}

void ResultFolder::forget_audit(const std::string& id) const {
  std::error_code ignored;
  process::remove_tree(audit(id));
  fs::remove(path_ / "audits", ignored);
}

}  // namespace runner

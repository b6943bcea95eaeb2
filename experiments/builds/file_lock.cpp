#include "experiments/builds/file_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace builds {

FileLock::FileLock(const std::filesystem::path& file, const std::function<void()>& waiting)
    : file_(::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644)) {
  if (file_ < 0) throw std::system_error(errno, std::generic_category(), file.string() + ": cannot be made");
  if (::flock(file_, LOCK_EX | LOCK_NB) == 0) return;
  waiting();
  while (::flock(file_, LOCK_EX) != 0) {
    if (errno != EINTR) throw std::system_error(errno, std::generic_category(), file.string() + ": no lock");
  }
}

FileLock::~FileLock() { ::close(file_); }

}  // namespace builds

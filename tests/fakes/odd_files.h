#pragma once

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

namespace fakes {

/// Something that is no regular file, and what is said of it.
struct OddFile {
  std::string name;  ///< of a test: letters only
  std::string sentence;
  void (*make)(const std::filesystem::path&);  ///< puts it there, in place of what is there
};

inline void make_pipe(const std::filesystem::path& path) {
  std::filesystem::remove_all(path);
  ::mkfifo(path.c_str(), 0600);
}

inline void make_socket(const std::filesystem::path& path) {
  std::filesystem::remove_all(path);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::strncpy(address.sun_path, path.c_str(), sizeof address.sun_path - 1);
  const int file = ::socket(AF_UNIX, SOCK_STREAM, 0);
  void* raw = &address;
  ::bind(file, static_cast<sockaddr*>(raw), sizeof address);
  ::close(file);
}

inline std::vector<OddFile> odd_files() {
  namespace fs = std::filesystem;
  return {{"Pipe", "is a named pipe (FIFO), a regular file is needed", make_pipe},
          {"Folder", "is a folder, a regular file is needed",
           [](const fs::path& path) {
             fs::remove_all(path);
             fs::create_directory(path);
           }},
          {"Socket", "is a socket, a regular file is needed", make_socket},
          {"EndlessDevice", "is a device, a regular file is needed", [](const fs::path& path) {
             fs::remove_all(path);
             fs::create_symlink("/dev/zero", path);
           }}};
}

}  // namespace fakes

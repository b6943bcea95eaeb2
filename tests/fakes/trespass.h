#pragma once

#include <arpa/inet.h>
#include <dirent.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/ptrace.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>

/// What a team might try on host, runner, the other team and the results; each tells whether it could have.
///
/// Nothing is harmed where it succeeds: signals are only asked for, files opened and not changed.
/// In a process view of its own, where the first process is bubblewrap's, everything that is
/// seen is killed in earnest.
namespace fakes {

class Trespass {
 public:
  /// Prints a line for each attempt that succeeded. From the environment: HOST_TEST, the number of the host's
  /// process; TRESPASS_FOLDER, the result folder; TRESPASS_PORT, where the host listens on 127.0.0.1.
  void try_all(const std::string& own_program) {
    tell("sees the host", ::kill(host_, 0) == 0);
    tell("traces the host", traces());
    tell("sees the other team", sees_other_team());
    tell("reads the ledger", opens(folder_ + "/ledger.sqlite", O_RDONLY));
    tell("writes the ledger", opens(folder_ + "/ledger.sqlite", O_WRONLY | O_APPEND));
    tell("writes a result", creates(folder_ + "/result.json"));
    tell("reads the home", opens(std::string(std::getenv("HOST_HOME")) + "/secret", O_RDONLY));
    tell("writes beside its program", creates(own_program + "-was-here"));
    tell("opens shared memory", opens("/dev/shm/matchday-test-" + std::to_string(host_), O_RDWR));
    tell("has capabilities", has_capabilities());
    tell("sets the kernel", opens("/proc/sys/kernel/core_pattern", O_WRONLY));
    tell("reaches TCP", reaches_tcp());
    tell("reaches an abstract socket", reaches_abstract());
    tell("uncovers the results", uncovers());
    kill_in_earnest();
    std::cout << "tried all" << std::endl;
  }

 private:
  static void tell(const char* what, bool succeeded) {
    if (succeeded) std::cout << "trespass: " << what << std::endl;
  }
  static bool opens(const std::string& file, int flags) {
    const int opened = ::open(file.c_str(), flags | O_CLOEXEC);
    if (opened >= 0) ::close(opened);
    return opened >= 0;
  }
  static bool creates(const std::string& file) {
    const bool made = opens(file, O_WRONLY | O_CREAT | O_EXCL);
    if (made) ::unlink(file.c_str());
    return made;
  }
  bool traces() const {
    if (::ptrace(PTRACE_SEIZE, host_, 0, 0) != 0) return false;
    ::ptrace(PTRACE_INTERRUPT, host_, 0, 0);
    int status = 0;
    ::waitpid(host_, &status, __WALL);
    ::ptrace(PTRACE_DETACH, host_, 0, 0);
    return true;
  }
  static bool sees_other_team() {
    const std::string own = std::getenv("MATCHDAY_SOCKET");
    for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
      std::ifstream file(entry.path() / "environ");
      for (std::string line; std::getline(file, line, '\0');) {
        if (line.starts_with("MATCHDAY_SOCKET=") && line != "MATCHDAY_SOCKET=" + own) return true;
      }
    }
    return false;
  }
  static bool has_capabilities() {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);) {
      if (line.starts_with("CapPrm:")) return line.find_first_of("123456789abcdef", 7) != std::string::npos;
    }
    return true;
  }
  static bool reaches_tcp() {
    const char* port = std::getenv("TRESPASS_PORT");
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(static_cast<std::uint16_t>(std::atoi(port)));
    return connects(AF_INET, &address, sizeof address);
  }
  bool reaches_abstract() const {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    const std::string name = "matchday-test-" + std::to_string(host_);
    std::memcpy(&address.sun_path[1], name.data(), name.size());
    return connects(AF_UNIX, &address,
                    static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + name.size()));
  }
  static bool connects(int family, const void* address, socklen_t size) {
    const int made = ::socket(family, SOCK_STREAM | SOCK_CLOEXEC, 0);
    const bool connected = ::connect(made, static_cast<const sockaddr*>(address), size) == 0;
    ::close(made);
    return connected;
  }
  /// As master of a world of its own it might take away what covers the folder.
  bool uncovers() const {
    const pid_t child = ::fork();
    if (child == 0) {
      const bool there = ::access((folder_ + "/ledger.sqlite").c_str(), F_OK) == 0;
      if (there || ::unshare(CLONE_NEWUSER | CLONE_NEWNS) != 0) ::_exit(0);
      for (const char* place : {folder_.c_str(), "/tmp", "/proc"}) ::umount2(place, MNT_DETACH);
      ::_exit(::access((folder_ + "/ledger.sqlite").c_str(), F_OK) == 0 ? 1 : 0);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) && WEXITSTATUS(status) == 1;
  }
  void kill_in_earnest() const {
    std::ifstream first("/proc/1/comm");
    std::string name;
    std::getline(first, name);
    if (name != "bwrap") return;
    ::kill(host_, SIGSTOP);
    for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
      const int number = std::atoi(entry.path().filename().c_str());
      if (number > 0 && number != ::getpid()) ::kill(number, SIGKILL);
    }
    ::kill(-1, SIGKILL);
  }

  pid_t host_ = std::atoi(std::getenv("HOST_TEST"));
  std::string folder_ = std::getenv("TRESPASS_FOLDER");
};

}  // namespace fakes

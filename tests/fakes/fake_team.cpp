// A team that misbehaves in one way, to see that the host notices, says so, and goes on.

#include <fcntl.h>
#include <linux/membarrier.h>
#include <sched.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "sim/wire/delimited.h"
#include "sim/wire/match.h"
#include "tests/fakes/hoard.h"
#include "tests/fakes/trespass.h"
#include "tests/fakes/unread.h"

namespace {

using namespace std::chrono_literals;

constexpr std::string_view usage = R"(fake-team --mode MODE [--at TICK] [--milliseconds N]

  good          stands still
  wander        drives its robots in circles given by the seed
  creep         tells its robots to drive a millionth of a metre a second
  never-connect runs but does not connect
  exit-at-start ends with code 3 before it connects
  no-hello      connects and is silent
  old-version   says it speaks protocol version 0
  bad-keeper    names a keeper it does not have
  silent        stops answering at TICK
  slow          takes 1 ms more for each answer
  crash         ends by a signal at TICK
  exit          ends with code 0 at TICK
  close         closes the socket at TICK and lives on
  wrong-tick    answers TICK with another number
  nonsense      answers TICK with bytes that are no message
  huge          answers TICK with a frame of 2 MiB
  flood         sends answers without end from TICK on
  chatter       prints 20 kB to standard output every tick
  not-numbers   sends speeds that are not finite
  ignore-term   stops answering at TICK, and ignores TERM
  fork-children starts processes of its own that sleep, then crashes at TICK
  daemons       starts sleeping processes in sessions of their own, without parents, and plays on
  exit-at-hello ends with code 4 when the host greets it
  crash-at-end  plays, and crashes when it is told that the game is over
  linger        plays, and stays when it is told that the game is over, ignoring TERM
  future-tick   answers TICK with a number far ahead
  two-answers   answers TICK twice, the second time with the number of the next one
  no-reply      answers TICK with a message that is empty
  endless       answers TICK with a length that never ends
  cut           sends half of its answer to TICK, and no more
  memory        takes 64 MiB more every tick from TICK on
  burst         takes memory without end at TICK and does not answer
  threads       starts 1200 threads at TICK and does not answer
  hoard         writes 64 MiB more every tick from TICK on into a file that is memory only
  hoard-apart   the same in a thread that has its open files for itself
  hoard-tmp     the same in a file of its folder for temporary files, which it closes; three times
  unlink        writes 64 MiB more every tick from TICK on into a file of its log folder that has no name
  reserve       has room for 64 MiB more every tick from TICK on set aside for an empty file in its log folder
  connect-twice connects a second time to its own socket at TICK
  intrude       connects to the other team's socket before its own, where it then plays
  intrude-late  connects to the other team's socket at TICK
  apart         plays in a process that is in no group, session or family of the one that was started
  writes        writes 64 MiB to a file in its log folder every tick
  litters       makes folders in folders in its log folder, a hundred every tick
  mess          leaves links, a pipe, a file with holes and folders without rights in its log folder
  trespass      tries at TICK to reach what is not its own, and prints what it could (trespass.h)
  gigabytes     prints 64 MiB to standard output every tick
  late          sleeps N ms before each answer from TICK on
  last-words    prints at TICK what reads like the end of a sentence of the host's, and ends with code 3
  reap          stops answering at TICK; six children at a time compute for a moment each and are not waited for
  think         computes N ms before each answer from TICK on
  unread        answers ticks from TICK on without reading them; when the host cannot write any more, reads one
                of them every N ms
  busy-late     the same as late, and computes in a thread all the time
  vfork         stops answering at TICK, in a wait for a child as uninterruptible as one for a disk
  barriers      stops answering at TICK, in short uninterruptible waits
  naps          stops answering at TICK, and is awake for a moment all the time
  naps-elsewhere  the same on all processors but those of the game
  idle          stops answering at TICK, and computes with the lowest priority
  modest-group  the same in a session of its own, which has a low priority
  vfork-late    sleeps N ms before each answer from TICK on, in a child of vfork
  burner        answers at once and computes in a process of its own all the time
  stray-burner  the same, in a session of its own, without parents
  notes         sends the longest note that is allowed, and as many unknown bytes, with every answer
  long-note     sends a note of 2000 bytes with its answer to TICK
  commands      answers TICK with 1000 empty robot commands
  megabyte      answers TICK with a mebibyte of empty robot commands
  long-name     has a name of 101 bytes
  megabyte-name has a name of a mebibyte
  escape-name   has a name with an escape sequence
  ahead         is one answer ahead from TICK on
  megabytes     sends a mebibyte of answers to TICK before it reads on
)";

struct Arguments {
  std::string mode = "good";
  std::int64_t at = 5;
  std::chrono::milliseconds span{50};
};

Arguments parse(int count, char** values) {
  Arguments arguments;
  for (int i = 1; i + 1 < count; i += 2) {
    const std::string_view flag = values[i];
    if (flag == "--mode") {
      arguments.mode = values[i + 1];
    } else if (flag == "--at") {
      arguments.at = std::stoll(values[i + 1]);
    } else if (flag == "--milliseconds") {
      arguments.span = std::chrono::milliseconds{std::stoi(values[i + 1])};
    } else {
      throw std::invalid_argument("unknown flag " + std::string(flag));
    }
  }
  if (count % 2 == 0) throw std::invalid_argument("a flag has no value");
  if (usage.find("\n  " + arguments.mode + " ") == std::string_view::npos) {
    throw std::invalid_argument("unknown mode " + arguments.mode);
  }
  return arguments;
}

[[noreturn]] void hang() {
  while (true) ::pause();
}

void crash() {
  const rlimit no_core{0, 0};
  ::setrlimit(RLIMIT_CORE, &no_core);
  ::signal(SIGSEGV, SIG_DFL);  // a sanitizer would turn the signal into an exit code
  ::raise(SIGSEGV);
}

/// Takes 64 MiB for good, and uses them.
void eat() {
  static std::vector<std::string> eaten;
  eaten.emplace_back(std::size_t{64} << 20, 'x');
}

/// Things that must not trouble whoever counts, keeps or removes them.
void leave_mess(const std::string& folder) {
  std::filesystem::create_symlink("/etc/passwd", folder + "/link");
  std::filesystem::create_directory_symlink("/", folder + "/root");
  std::filesystem::create_directory_symlink(folder, folder + "/circle");
  ::mkfifo((folder + "/pipe").c_str(), 0600);
  std::ofstream(folder + "/holes") << "x";
  std::filesystem::resize_file(folder + "/holes", std::uintmax_t{1} << 40);
  std::filesystem::create_directories(folder + "/closed/inner");
  ::chmod((folder + "/closed/inner").c_str(), 0);
  ::chmod((folder + "/closed").c_str(), 0);
}

/// A hundred folders more, each in the one before.
void litter(const std::string& folder) {
  static int at = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY);
  for (int i = 0; i < 100; ++i) {
    ::mkdirat(at, "deeper", 0700);
    const int next = ::openat(at, "deeper", O_RDONLY | O_DIRECTORY);
    ::close(at);
    at = next;
  }
}

[[noreturn]] void burn() {
  ::alarm(120);  // for a test that fails
  while (true) std::clock();
}

/// Computes for so long, of its own processor time.
void think(std::chrono::milliseconds span) {
  const auto used = [] { return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; };
  const double end = used() + static_cast<double>(span.count());
  while (used() < end) {
  }
}

/// Waits without end, but so that it looks as if the machine were to blame.
[[noreturn]] void pretend(const std::string& mode) {
  if (mode == "vfork" && ::vfork() == 0) {  // NOLINT(clang-analyzer-security.insecureAPI.vfork)
    ::sleep(120);
    ::_exit(0);
  }
  if (mode == "idle") {
    const sched_param none{};
    ::sched_setscheduler(0, SCHED_IDLE, &none);
  }
  if (mode == "naps-elsewhere") {
    cpu_set_t ours;
    ::sched_getaffinity(0, sizeof ours, &ours);
    cpu_set_t others;
    CPU_ZERO(&others);
    for (std::size_t i = 0; i < CPU_SETSIZE; ++i) {
      if (!CPU_ISSET(i, &ours)) CPU_SET(i, &others);
    }
    ::sched_setaffinity(0, sizeof others, &others);
  }
  if (mode == "modest-group") std::ofstream("/proc/self/autogroup") << 19;
  if (mode == "idle" || mode == "modest-group") burn();
  while (true) {
    if (mode == "barriers") ::syscall(SYS_membarrier, MEMBARRIER_CMD_GLOBAL, 0, 0);
    if (mode.starts_with("naps")) ::usleep(50);
  }
}

/// Computes in children that end all the time and are reaped by the kernel: their processor time is in nobody's
/// sum.
[[noreturn]] void reap() {
  ::signal(SIGCHLD, SIG_IGN);
  const auto start_children = [] {
    while (true) {
      const pid_t child = ::fork();
      if (child == 0) {
        think(30ms);
        ::_exit(0);
      }
      ::waitpid(child, nullptr, 0);
    }
  };
  for (int at_a_time = 0; at_a_time < 6; ++at_a_time) std::thread(start_children).detach();
  burn();
}

/// Starts what `burner`, `stray-burner` and `busy-late` have beside them.
void start_burning(const std::string& mode) {
  if (mode == "busy-late") std::thread(burn).detach();
  if (mode == "burner" && ::fork() == 0) burn();
  if (mode == "stray-burner") {
    const pid_t child = ::fork();
    if (child == 0) {
      ::setsid();
      if (::fork() != 0) ::_exit(0);
      burn();
    }
    ::waitpid(child, nullptr, 0);
  }
}

/// Two processes that are in no group, session or family of ours.
void start_daemons() {
  for (int daemon = 0; daemon < 2; ++daemon) {
    if (::fork() != 0) continue;
    ::setsid();
    if (::fork() != 0) ::_exit(0);
    hang();
  }
}

std::string own_socket() {
  const char* path = std::getenv("MATCHDAY_SOCKET");
  if (path == nullptr) throw std::runtime_error("MATCHDAY_SOCKET is not set");
  return path;
}

/// The other team's socket, as its environment in /proc names it; waits for that.
std::string others_socket() {
  const std::string name = "MATCHDAY_SOCKET=";
  const char* game = std::getenv("HOST_TEST");  // of this test, if there are several at once
  for (int attempt = 0; attempt < 1000; ++attempt) {
    for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
      std::ifstream file(entry.path() / "environ");
      std::string found;
      bool same_game = game == nullptr;
      for (std::string line; std::getline(file, line, '\0');) {
        if (line.starts_with(name)) found = line.substr(name.size());
        same_game = same_game || line == std::string("HOST_TEST=") + game;
      }
      if (same_game && !found.empty() && found != own_socket()) return found;
    }
    ::usleep(5000);
  }
  throw std::runtime_error("there is no other team");
}

class Connection {
 public:
  explicit Connection(const std::string& path = own_socket()) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::strncpy(address.sun_path, path.c_str(), sizeof address.sun_path - 1);
    socket_ = ::socket(AF_UNIX, SOCK_STREAM, 0);
    void* raw = &address;
    if (::connect(socket_, static_cast<sockaddr*>(raw), sizeof address) != 0) {
      throw std::runtime_error("cannot connect to " + path);
    }
  }

  /// False when the host is gone.
  bool send(std::string_view bytes) const {
    while (!bytes.empty()) {
      const ssize_t count = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
      if (count <= 0) return false;
      bytes.remove_prefix(static_cast<std::size_t>(count));
    }
    return true;
  }
  bool send(const wire::proto::TeamMessage& message) const {
    std::string frame;
    wire::append_frame(frame, message);
    return send(frame);
  }

  bool receive(wire::proto::HostMessage& message) {
    while (true) {
      if (const auto frame = reader_.next()) {
        return message.ParseFromArray(frame->data(), static_cast<int>(frame->size()));
      }
      const ssize_t count = ::recv(socket_, buffer_.data(), buffer_.size(), 0);
      if (count <= 0) return false;
      reader_.append({buffer_.data(), static_cast<std::size_t>(count)});
    }
  }

  void close() const { ::close(socket_); }
  int socket() const { return socket_; }

 private:
  int socket_ = -1;
  wire::FrameReader reader_;
  std::vector<std::byte> buffer_ = std::vector<std::byte>(65536);
};

void drive_in_circles(const wire::proto::MatchHello& hello, wire::proto::RobotControl& control) {
  for (const std::uint32_t robot : hello.robots()) {
    auto& command = *control.add_robot_commands();
    command.set_id(robot);
    auto& velocity = *command.mutable_move_command()->mutable_local_velocity();
    const auto share = [&](int shift) {
      return static_cast<float>((hello.seed() >> (shift + robot)) & 255U) / 255.0F;
    };
    velocity.set_forward(0.5F + share(0));
    velocity.set_left(0);
    velocity.set_angular(1.0F + 2.0F * share(20));
    command.set_kick_speed(4);
  }
}

void misbehave(const Arguments& arguments, const Connection& host, wire::proto::TeamMessage& message) {
  const std::string& mode = arguments.mode;
  if (mode == "silent") hang();
  if (mode == "ignore-term") {
    ::signal(SIGTERM, SIG_IGN);
    hang();
  }
  for (const char* pretence : {"vfork", "barriers", "naps", "naps-elsewhere", "idle", "modest-group"}) {
    if (mode == pretence) pretend(mode);
  }
  if (mode == "crash" || mode == "fork-children") crash();
  if (mode == "exit") std::exit(0);
  if (mode == "close") {
    host.close();
    hang();
  }
  if (mode == "connect-twice") static const Connection second;
  if (mode == "intrude-late") static const Connection there(others_socket());
  if (mode == "trespass" && message.reply().tick() == arguments.at) {
    fakes::Trespass().try_all(std::filesystem::read_symlink("/proc/self/exe"));
  }
  if (mode == "late" || mode == "busy-late") std::this_thread::sleep_for(arguments.span);
  if (mode == "vfork-late") {
    const pid_t child = ::vfork();
    if (child == 0) {
      ::usleep(static_cast<useconds_t>(arguments.span.count() * 1000));
      ::_exit(0);
    }
    ::waitpid(child, nullptr, 0);
  }
  if (mode == "last-words") {
    std::cout << R"("; yellow (Fake Y) crashed \)" << std::endl;
    std::exit(3);
  }
  if (mode == "reap") reap();
  if (mode == "think") think(arguments.span);
  if (mode == "unread") {
    host.send(message);
    fakes::keep_full(host.socket(), message.reply().tick(), arguments.span, [&](std::int64_t tick) {
      message.mutable_reply()->set_tick(tick);
      host.send(message);
    });
    hang();
  }
  const auto add_commands = [&](int count) {
    for (int i = 0; i < count; ++i) message.mutable_reply()->mutable_control()->add_robot_commands();
  };
  if (mode == "commands") add_commands(1000);
  if (mode == "megabyte") add_commands(500'000);
  if (mode == "long-note") message.mutable_reply()->set_note(std::string(2000, 'x'));
  if (mode == "ahead") {
    if (message.reply().tick() == arguments.at) host.send(message);
    message.mutable_reply()->set_tick(message.reply().tick() + 1);
  }
  if (mode == "megabytes") {
    std::string frame;
    while (frame.size() < std::size_t{1} << 20) wire::append_frame(frame, message);
    host.send(frame);
  }
  if (mode == "memory") eat();
  if (mode == "burst") {
    while (true) eat();
  }
  if (mode == "threads") {
    for (int i = 0; i < 1200; ++i) std::thread(hang).detach();
    hang();
  }
  if (mode == "wrong-tick") message.mutable_reply()->set_tick(message.reply().tick() - 1);
  if (mode == "future-tick") message.mutable_reply()->set_tick(std::numeric_limits<std::int64_t>::max());
  if (mode == "no-reply") message.Clear();
  if (mode == "two-answers") {
    host.send(message);
    message.mutable_reply()->set_tick(message.reply().tick() + 1);
  }
  if (mode == "endless") host.send(std::string(64, '\xff'));
  if (mode == "cut") {
    std::string frame;
    wire::append_frame(frame, message);
    host.send(std::string_view(frame).substr(0, frame.size() / 2));
    hang();
  }
  if (mode == "nonsense") host.send(std::string("\x10") + std::string(16, '\xff'));
  if (mode == "huge") host.send(std::string("\x80\x80\x80\x01") + std::string(std::size_t{2} << 20, 'x'));
  if (mode == "flood") {
    while (host.send(message)) {
    }
    hang();
  }
}

int play(const Arguments& arguments) {
  const std::string& mode = arguments.mode;
  if (mode == "exit-at-start") return 3;
  if (mode == "never-connect") hang();
  if (mode == "fork-children") {
    for (int child = 0; child < 2; ++child) {
      if (::fork() == 0) hang();
    }
  }
  if (mode == "daemons") start_daemons();
  if (mode == "intrude") static const Connection there(others_socket());
  if (mode == "apart" && ::fork() != 0) hang();
  if (mode == "apart") {
    ::setsid();
    if (::fork() != 0) ::_exit(0);
  }
  start_burning(mode);
  if (mode == "modest-group") {
    if (::fork() != 0) hang();
    ::setsid();
  }
  if (mode == "linger") ::signal(SIGTERM, SIG_IGN);

  Connection host;
  if (mode == "no-hello") hang();
  wire::proto::HostMessage from_host;
  if (!host.receive(from_host) || !from_host.has_hello()) return 1;
  if (mode == "exit-at-hello") return 4;
  const wire::proto::MatchHello hello = from_host.hello();
  wire::proto::TeamMessage to_host;
  to_host.mutable_hello()->set_protocol_version(mode == "old-version" ? 0 : wire::match_protocol_version);
  to_host.mutable_hello()->set_name("fake-team");
  to_host.mutable_hello()->set_version(mode);
  if (mode == "long-name") to_host.mutable_hello()->set_name(std::string(101, 'x'));
  if (mode == "megabyte-name") to_host.mutable_hello()->set_name(std::string((1U << 20) - 100, 'x'));
  if (mode == "escape-name") to_host.mutable_hello()->set_name("\x1b[2J");
  if (mode == "bad-keeper") to_host.mutable_hello()->set_keeper(15);
  host.send(to_host);

  while (host.receive(from_host)) {
    if (from_host.has_goodbye()) {
      if (mode == "crash-at-end") crash();
      if (mode == "linger") hang();
      return 0;
    }
    const std::int64_t tick = from_host.tick().tick();
    to_host.Clear();
    to_host.mutable_reply()->set_tick(tick);
    wire::proto::RobotControl& control = *to_host.mutable_reply()->mutable_control();
    if (mode == "wander") drive_in_circles(hello, control);
    if (mode == "creep") {
      drive_in_circles(hello, control);
      for (auto& command : *control.mutable_robot_commands()) {
        command.mutable_move_command()->mutable_local_velocity()->set_forward(1e-6F);
        command.mutable_move_command()->mutable_local_velocity()->set_angular(0);
      }
    }
    if (mode == "not-numbers") {
      drive_in_circles(hello, control);
      control.mutable_robot_commands(0)->mutable_move_command()->mutable_local_velocity()->set_forward(
          std::numeric_limits<float>::quiet_NaN());
    }
    if (mode == "gigabytes") std::cout << std::string(std::size_t{64} << 20, '.') << std::flush;
    if (mode == "writes") {
      std::ofstream(hello.log_directory() + "/big", std::ios::app) << std::string(std::size_t{64} << 20, '.');
    }
    if (mode == "litters") litter(hello.log_directory());
    if (mode == "mess" && tick == 1) leave_mess(hello.log_directory());
    if (mode == "notes") {
      drive_in_circles(hello, control);
      to_host.mutable_reply()->set_note(std::string(1024, 'x'));
      control.GetReflection()->MutableUnknownFields(&control)->AddLengthDelimited(99, std::string(1024, 'x'));
    }
    if (mode == "slow") ::usleep(1000);
    if (mode == "chatter") std::cout << std::string(20'000, '.') << std::flush;
    if (tick >= arguments.at) fakes::hoard(mode, hello.log_directory());
    if (tick >= arguments.at) misbehave(arguments, host, to_host);
    if (!host.send(to_host)) return 1;
  }
  return 0;
}

}  // namespace

int main(int count, char** values) {
  try {
    return play(parse(count, values));
  } catch (const std::exception& error) {
    std::cerr << "fake-team: " << error.what() << "\n\n" << usage;
    return 2;
  }
}

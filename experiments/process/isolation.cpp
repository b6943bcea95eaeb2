#include "experiments/process/isolation.h"

#include <pwd.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <system_error>

#include "experiments/process/child.h"

namespace process {
namespace {

namespace fs = std::filesystem;

// Of each writable folder that is only in memory: temporary files, home, shared memory; ours.
constexpr const char* room = "268435456";  // [bytes] 256 MiB

// A folder that nothing is started without can be no home.
constexpr std::array system_folders{"/usr", "/bin",  "/sbin", "/lib", "/lib64",
                                    "/etc", "/proc", "/dev",  "/sys"};
// Temporary files, and sockets of services that start programs for whoever asks.
constexpr std::array foreign_folders{"/tmp", "/var/tmp", "/run"};
// They name places that are not there.
constexpr std::array foreign_variables{"XDG_RUNTIME_DIR", "XDG_CONFIG_HOME", "XDG_CACHE_HOME",
                                       "XDG_DATA_HOME",   "XDG_STATE_HOME",  "DBUS_SESSION_BUS_ADDRESS",
                                       "SSH_AUTH_SOCK"};

/// With all links resolved; empty when there is no such thing.
fs::path real(const fs::path& path) {
  std::error_code error;
  fs::path found = fs::canonical(path, error);
  return error ? fs::path{} : found;
}

bool is_in(const fs::path& path, const fs::path& folder) {  // or is it
  const auto [end, ignored] = std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
  return end == folder.end();
}

template <class Folders>
bool is_in_any(const fs::path& path, const Folders& folders) {
  return std::any_of(folders.begin(), folders.end(),
                     [&](const fs::path& folder) { return is_in(path, folder); });
}

/// Where all of an installed program is: above its `bin`.
std::vector<fs::path> installation(const fs::path& folder) {
  const std::string last = folder.filename().string();
  const fs::path above = folder.parent_path();
  if ((last != "bin" && last != "sbin" && last != "shims") || above == above.root_path()) return {folder};
  const std::string name = above.filename().string();
  // These hold private things, too, as passwords of package registries.
  if (name == ".local" || name == ".cargo") return {folder, above / "lib"};
  return {folder, above};
}

std::vector<fs::path> homes() {
  std::vector<fs::path> found;
  if (const char* variable = std::getenv("HOME")) found.push_back(real(variable));
  if (const passwd* user = ::getpwuid(::geteuid())) found.push_back(real(user->pw_dir));
  std::erase_if(found, [](const fs::path& home) {
    std::error_code ignored;
    return home.empty() || !fs::is_directory(home, ignored) ||
           std::any_of(system_folders.begin(), system_folders.end(),
                       [&](const char* folder) { return is_in(folder, home) || is_in(home, folder); });
  });
  return found;
}

/// Of the programs that are found by their names: beside ours and by PATH, see find_program().
std::vector<fs::path> installations() {
  std::error_code ignored;
  std::vector<fs::path> found = installation(fs::read_symlink("/proc/self/exe", ignored).parent_path());
  const char* variable = std::getenv("PATH");
  std::string_view rest = variable != nullptr ? variable : "";
  while (!rest.empty()) {
    const std::size_t end = rest.find(':');
    if (const std::string_view folder = rest.substr(0, end); !folder.empty()) {
      for (const fs::path& part : installation(folder)) found.push_back(part);
    }
    rest = end == std::string_view::npos ? std::string_view{} : rest.substr(end + 1);
  }
  return found;
}

/// The files and folders that the arguments name: as a whole, or as a word with a / in them, as in
/// "--model=folder/file" or in what a shell is told.
std::vector<fs::path> named(const std::vector<std::string>& arguments, const fs::path& directory) {
  std::vector<fs::path> found;
  const auto add = [&](const std::string& word) {
    std::error_code error;
    const fs::path path = fs::absolute(directory / word, error).lexically_normal();
    if (!error && (fs::is_directory(path, error) || fs::is_regular_file(path, error))) found.push_back(path);
  };
  for (std::size_t i = 1; i < arguments.size(); ++i) {
    const std::string& argument = arguments[i];
    if (argument.empty()) continue;
    add(argument);
    constexpr const char* between = " \t\n\"'`;=:,&|()<>$";
    for (std::size_t begin = 0; (begin = argument.find_first_not_of(between, begin)) != std::string::npos;) {
      const std::size_t end = std::min(argument.find_first_of(between, begin), argument.size());
      const std::string word = argument.substr(begin, end - begin);
      if (word != argument && word.find('/') != std::string::npos) add(word);
      begin = end;
    }
  }
  return found;
}

/// What is mounted where, outer folders before those in them.
class Mounts {
 public:
  Mounts(const Cell& cell, const fs::path& program, const std::vector<std::string>& arguments,
         const fs::path& directory) {
    const std::vector<fs::path> own_homes = homes();
    for (const char* folder : foreign_folders) mask(real(folder), masked_);
    for (const fs::path& home : own_homes) mask(home, masked_);
    for (const fs::path& folder : cell.hidden) {
      if (!plan_.contains(real(folder))) mask(real(folder), hidden_);  // a home is empty already
    }

    // What every program of this user may need, but not in what is hidden.
    show_usual(directory);
    for (const fs::path& part : installations()) show_usual(part);
    show_usual("/etc/resolv.conf");
    for (const fs::path& path : cell.visible) {
      if (const fs::path source = real(path); is_covered(source)) plan_[source] = {Kind::ReadOnly, source};
    }
    std::vector<std::string> command = arguments;
    command.front() = program.string();
    for (const fs::path& path : needed_folders(command, directory)) show(path);
    // Where the folder itself is not shown, as the home as a whole.
    for (const fs::path& path : named(arguments, directory)) show_file(path);
    show_file(program);
    for (const fs::path& path : cell.writable) plan_[real(path)] = {Kind::Writable, real(path)};
    forget_unreachable();
    home_ = own_homes.empty() ? fs::path("/tmp/home") : own_homes.front();
  }

  const fs::path& home() const { return home_; }

  void append_to(std::vector<std::string>& words) const {
    for (const auto& [path, mount] : plan_) {
      switch (mount.kind) {
        case Kind::Empty:
          words.insert(words.end(), {"--size", room, "--tmpfs", path.string()});
          break;
        case Kind::ReadOnly:
          words.insert(words.end(), {"--ro-bind", mount.source.string(), path.string()});
          break;
        case Kind::Writable:
          words.insert(words.end(), {"--bind", mount.source.string(), path.string()});
          break;
      }
    }
  }

  /// Only the places that are meant for it take what a program writes.
  void close_hidden(std::vector<std::string>& words) const {
    for (const fs::path& path : hidden_) {
      const auto there = plan_.find(path);
      if (there == plan_.end() || there->second.kind != Kind::Empty) continue;
      words.insert(words.end(), {"--remount-ro", path.string()});
    }
  }

 private:
  enum class Kind { Empty, ReadOnly, Writable };
  struct Mount {
    Kind kind{};
    fs::path source;
  };

  void mask(const fs::path& folder, std::vector<fs::path>& list) {
    std::error_code ignored;
    if (folder.empty() || folder == "/" || !fs::is_directory(folder, ignored)) return;
    list.push_back(folder);
    plan_[folder] = {Kind::Empty, {}};
  }

  /// A hidden folder in one that is empty itself is not there at all, so that not even its name is seen.
  void forget_unreachable() {
    for (const fs::path& path : hidden_) {
      const auto place = plan_.find(path);
      if (place == plan_.end() || place->second.kind != Kind::Empty) continue;
      const auto inner = std::next(place);  // the plan is sorted by path: what is in a folder follows it
      if (inner != plan_.end() && is_in(inner->first, path)) continue;
      fs::path above = path.parent_path();
      while (above != above.root_path() && !plan_.contains(above)) above = above.parent_path();
      const auto outer = plan_.find(above);
      if (outer != plan_.end() && outer->second.kind == Kind::Empty) plan_.erase(place);
    }
  }

  bool is_covered(const fs::path& path) const { return is_in_any(path, masked_) || is_in_any(path, hidden_); }

  void show_usual(const fs::path& path) {
    const fs::path source = real(path);
    if (source.empty() || !is_in_any(source, masked_) || is_in_any(source, hidden_)) return;
    plan_.try_emplace(source, Mount{Kind::ReadOnly, source});  // not over a home as a whole
  }

  /// By its own name, and by the one it is called by where links lead to it.
  void show(const fs::path& path) {
    const fs::path source = real(path);
    if (source.empty()) return;
    for (const fs::path& place : {source, fs::absolute(path).lexically_normal()}) {
      if (is_covered(place)) plan_.try_emplace(place, Mount{Kind::ReadOnly, source});
    }
  }

  void show_file(const fs::path& file) {
    const fs::path folder = file.parent_path();
    const auto there = plan_.find(real(folder));
    if (there != plan_.end() && there->second.kind == Kind::Empty) show(file);
  }

  std::vector<fs::path> masked_;
  std::vector<fs::path> hidden_;
  std::map<fs::path, Mount> plan_;
  fs::path home_;
};

/// What the kernel shows of itself in /proc, processes left out: settings that root may write even without
/// capabilities, as core_pattern, and for which a namespace is no hindrance.
std::set<std::string> kernel_places() {
  std::set<std::string> found;
  std::error_code error;
  fs::directory_iterator entries("/proc", error);
  for (; !error && entries != fs::directory_iterator(); entries.increment(error)) {
    const std::string word = entries->path().filename().string();
    struct stat status {};
    const bool is_process = word.find_first_not_of("0123456789") == std::string::npos;
    if (is_process || ::lstat(entries->path().c_str(), &status) != 0) continue;
    const bool may_be_written = S_ISREG(status.st_mode) && (status.st_mode & 0222U) != 0;
    if (S_ISDIR(status.st_mode) || may_be_written) found.insert(entries->path().string());
  }
  return found;
}

/// Whether programs can make user namespaces here, as bubblewrap finds out for --unshare-user-try.
bool namespaces_can_be_made() {
  std::ifstream stream("/proc/sys/user/max_user_namespaces");
  long most = 1;  // an old kernel that does not say
  stream >> most;
  return ::access("/proc/self/ns/user", F_OK) == 0 && most > 0;
}

/// Whether this bubblewrap can forbid it in a cell: not one before 0.8.0, nor one with rights of its own
/// (set-user-ID). Its help is looked for in its file: starting it may fail for a moment, and a cell would be
/// weaker than what was said.
bool can_forbid_namespaces(const fs::path& bubblewrap) {
  struct stat status {};
  if (::stat(bubblewrap.c_str(), &status) != 0 || (status.st_mode & S_ISUID) != 0) return false;
  std::ifstream stream(bubblewrap, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  return text.find("--disable-userns") != std::string::npos;
}

}  // namespace

const char* name(Isolation level) {
  constexpr std::array<const char*, 3> names = {"none", "files", "network"};
  return names.at(static_cast<std::size_t>(level));
}

std::optional<Isolation> isolation_from_name(std::string_view word) {
  for (const Isolation level : {Isolation::None, Isolation::Files, Isolation::Network}) {
    if (word == name(level)) return level;
  }
  return std::nullopt;
}

std::vector<fs::path> needed_folders(const std::vector<std::string>& arguments, const fs::path& directory) {
  std::vector<fs::path> found;
  const auto add = [&found](const fs::path& path) {
    if (std::find(found.begin(), found.end(), path) == found.end()) found.push_back(path);
  };
  try {
    const fs::path program = find_program(arguments.front(), directory);
    for (const fs::path& file : {program.lexically_normal(), real(program)}) {
      for (const fs::path& folder : installation(file.parent_path())) add(folder);
    }
  } catch (const StartError&) {
    return {};
  }
  if (!directory.empty()) add(fs::absolute(directory).lexically_normal());
  std::error_code ignored;
  for (const fs::path& path : named(arguments, directory)) {
    add(fs::is_directory(path, ignored) ? path : path.parent_path());
  }
  return found;
}

std::vector<fs::path> not_shared(const std::vector<fs::path>& others, const std::vector<fs::path>& own,
                                 const fs::path& directory) {
  std::vector<fs::path> result;
  std::vector<fs::path> needed = own;
  for (const fs::path& part : installations()) needed.push_back(part);
  const fs::path work = directory.empty() ? fs::current_path() : real(directory);
  for (const fs::path& folder : others) {
    const fs::path path = real(folder);
    const auto meets = [&](const fs::path& one) {
      const fs::path there = real(one);
      return !there.empty() && (is_in(there, path) || is_in(path, there));
    };
    const auto is_system = [&](const char* one) { return is_in(path, one) || is_in(one, path); };
    if (path.empty() || is_in(work, path) || std::any_of(needed.begin(), needed.end(), meets)) continue;
    if (std::any_of(system_folders.begin(), system_folders.end(), is_system)) continue;
    if (std::any_of(foreign_folders.begin(), foreign_folders.end(),
                    [&](const char* one) { return path == one; }))
      continue;
    result.push_back(path);
  }
  return result;
}

std::vector<std::string> isolated_command(const Cell& cell, int status, const fs::path& program,
                                          const std::vector<std::string>& arguments,
                                          const fs::path& directory) {
  const fs::path work = directory.empty() ? fs::current_path() : real(directory);
  const Mounts mounts(cell, program, arguments, work);
  const fs::path bubblewrap = find_program("bwrap");
  std::vector<std::string> words = {
      bubblewrap.string(), "--unshare-pid", "--unshare-ipc", "--unshare-uts",    "--unshare-cgroup-try",
      "--die-with-parent", "--cap-drop",    "ALL",           "--json-status-fd", std::to_string(status)};
  // In a user namespace of its own a program could mount: control groups, with which root ends the host.
  if (namespaces_can_be_made() && can_forbid_namespaces(bubblewrap)) {
    words.insert(words.end(), {"--unshare-user", "--disable-userns"});
  } else {
    words.emplace_back("--unshare-user-try");
  }
  if (cell.level == Isolation::Network) words.emplace_back("--unshare-net");
  // No way to our terminal, whose shell would take what is typed there; a session of its own (setsid) would
  // have the scheduler's autogroups treat each team as much as all else of a user.
  words.insert(words.end(),
               {"--ro-bind", "/", "/", "--proc", "/proc", "--dev", "/dev", "--size", room, "--tmpfs",
                "/dev/shm", "--ro-bind", "/dev/null", "/dev/tty", "--remount-ro", "/dev"});
  for (const std::string& place : kernel_places()) words.insert(words.end(), {"--ro-bind", place, place});
  mounts.append_to(words);
  words.insert(words.end(), {"--dir", mounts.home().string(), "--dir", work.string()});
  mounts.close_hidden(words);
  words.insert(words.end(), {"--setenv", "HOME", mounts.home().string(), "--setenv", "TMPDIR", "/tmp"});
  for (const char* variable : foreign_variables) words.insert(words.end(), {"--unsetenv", variable});
  words.insert(words.end(), {"--chdir", work.string(), "--", program.string()});
  words.insert(words.end(), arguments.begin() + 1, arguments.end());
  return words;
}

IsolationLimit isolation_limit() {
  IsolationLimit limit;
  for (const Isolation level : {Isolation::Network, Isolation::Files}) {
    try {
      Command command;
      command.arguments = {"/bin/true"};
      command.directory = "/";
      command.cell = Cell{.level = level, .hidden = {}, .visible = {}, .writable = {}};
      Child child(command);
      child.wait(std::chrono::seconds{10});  // 10 ms on an idle machine
      const Exit exit = child.stop(std::chrono::milliseconds{0});
      if (exit.clean()) {
        limit.strongest = level;
        if (namespaces_can_be_made() && !can_forbid_namespaces(find_program("bwrap"))) {
          limit.gap =
              "programs can make namespaces of their own (bubblewrap from 0.8.0 on, without set-user-ID, "
              "prevents that)";
        }
        return limit;
      }
      if (limit.problem.empty()) {
        const std::string said = child.output().last_line();
        limit.problem = said.empty() ? "bwrap " + exit.describe() : said;
      }
    } catch (const StartError&) {
      limit.problem = "bubblewrap is not installed (package bubblewrap)";
      return limit;
    }
  }
  return limit;
}

}  // namespace process

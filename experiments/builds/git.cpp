#include "experiments/builds/git.h"

#include <stdlib.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "experiments/process/child.h"
#include "experiments/schedule/nearest.h"

namespace builds {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::minutes git_patience{30};              // a large repository over a slow line
constexpr std::chrono::milliseconds grace{2'000};             // between TERM and KILL
constexpr std::size_t longest_answer = std::size_t{1} << 20;  // [bytes]

/// A file that goes away.
class Scratch {
 public:
  Scratch() {
    std::string name = (fs::temp_directory_path() / "matchday-git-XXXXXX").string();
    const int file = ::mkstemp(name.data());
    if (file < 0) throw std::runtime_error("cannot make a file in " + fs::temp_directory_path().string());
    ::close(file);
    path_ = name;
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  ~Scratch() {
    std::error_code ignored;
    fs::remove(path_, ignored);
  }
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

Said git(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "git");
  return listen_to(arguments, {}, git_patience);
}

/// The last line that says something, on one line.
std::string last_line(const std::string& text) {
  std::istringstream lines(text);
  std::string last;
  for (std::string line; std::getline(lines, line);) {
    if (line.find_first_not_of(" \t\r") != std::string::npos) last = line;
  }
  return last;
}

[[noreturn]] void complain(const std::string& who, const std::string& repository,
                           const std::string& problem) {
  throw std::invalid_argument(who + ": repository '" + repository + "': " + problem);
}

std::string trimmed(const std::string& text) { return text.substr(0, text.find_first_of("\r\n ")); }

bool is_commit(const std::string& text) {
  return text.size() >= 40 && text.find_first_not_of("0123456789abcdef") == std::string::npos;
}

}  // namespace

Said listen_to(const std::vector<std::string>& command, const fs::path& directory,
               std::chrono::milliseconds patience) {
  const Scratch output;
  bool well = false;
  {
    process::Command start;
    start.arguments = command;
    start.environment = {{"GIT_TERMINAL_PROMPT", "0"}, {"LC_ALL", "C"}};  // nobody is there to answer
    start.directory = directory;
    start.output = output.path();
    start.output_limit = longest_answer;
    process::Child child(start);
    const bool ended = child.wait(patience);
    well = child.stop(ended ? std::chrono::milliseconds{0} : grace).clean() && ended;
  }
  std::ifstream stream(output.path());
  std::ostringstream text;
  text << stream.rdbuf();
  return {well, text.str()};
}

bool is_remote(const std::string& repository) {
  if (repository.find("://") != std::string::npos) return true;
  const std::size_t colon = repository.find(':');  // git@host:path, as scp has it
  return colon != std::string::npos && repository.substr(0, colon).find('/') == std::string::npos;
}

std::string commit_of(const std::string& repository, const std::string& revision, const std::string& who) {
  const Said inside = git({"-C", repository, "rev-parse", "--git-dir"});
  if (!inside.well) complain(who, repository, "is no git repository; git says: " + last_line(inside.text));
  for (const std::string& name : {revision, "origin/" + revision}) {
    const Said found =
        git({"-C", repository, "rev-parse", "--verify", "--quiet", "--end-of-options", name + "^{commit}"});
    const std::string commit = trimmed(found.text);
    if (found.well && is_commit(commit)) return commit;
  }
  const Said refs =
      git({"-C", repository, "for-each-ref", "--format=%(refname:short)", "refs/heads", "refs/tags"});
  std::vector<std::string> names;
  std::istringstream lines(refs.text);
  for (std::string name; std::getline(lines, name);) names.push_back(name);
  complain(who, repository,
           "has no revision '" + revision + "'" + schedule::did_you_mean(revision, names) +
               (names.empty() ? "; it has no commit yet" : ""));
}

void mirror(const std::string& address, const fs::path& copy, const std::string& who) {
  const bool there = fs::exists(copy / "HEAD");
  const Said said = there ? git({"-C", copy.string(), "fetch", "--quiet", "--prune", "origin"})
                          : git({"clone", "--quiet", "--mirror", address, copy.string()});
  if (!said.well) complain(who, address, "cannot be fetched; git says: " + last_line(said.text));
}

void check_out(const std::string& repository, const std::string& commit, const fs::path& folder,
               const std::string& who) {
  fs::remove_all(folder);
  // --force: the folder may have been deleted by hand, which git still remembers as a checkout.
  const Said said =
      git({"-C", repository, "worktree", "add", "--force", "--detach", folder.string(), commit});
  if (!said.well) {
    complain(who, repository,
             "commit " + commit + " cannot be checked out; git says: " + last_line(said.text));
  }
}

}  // namespace builds

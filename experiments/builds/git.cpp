#include "experiments/builds/git.h"

#include <sstream>
#include <utility>

#include "experiments/process/filter.h"
#include "experiments/schedule/nearest.h"

namespace builds {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::minutes git_patience{30};              // a large repository over a slow line
constexpr std::chrono::milliseconds grace{2'000};             // between TERM and KILL
constexpr std::size_t longest_answer = std::size_t{1} << 20;  // [bytes]

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

/// The commit that a name means to git; empty when it means none.
std::string resolved(const std::string& repository, const std::string& name) {
  const Said found =
      git({"-C", repository, "rev-parse", "--verify", "--quiet", "--end-of-options", name + "^{commit}"});
  const std::string commit = trimmed(last_line(found.text));  // git may warn before it
  return found.well && is_commit(commit) ? commit : std::string{};
}

/// A branch and a tag may have one name, and git takes the tag without a word: then the name says nothing.
void reject_ambiguous(const std::string& repository, const std::string& revision, const std::string& commit,
                      const std::string& who) {
  std::string meanings;
  bool alike = true;
  const auto consider = [&](const std::string& name) {
    const std::string other = resolved(repository, name);
    if (other.empty()) return false;
    meanings += (meanings.empty() ? "" : ", ") + name + " is commit " + other.substr(0, 12);
    alike = alike && other == commit;
    return true;
  };
  consider("refs/" + revision);
  // A branch of the origin of the same name is no other meaning: ours goes first, as with git.
  if (!consider("refs/heads/" + revision)) consider("refs/remotes/origin/" + revision);
  consider("refs/tags/" + revision);
  if (alike) return;
  complain(who, repository,
           "the revision '" + revision + "' is ambiguous: " + meanings +
               "; write the one that is meant with its full name, as refs/heads/" + revision +
               " for the branch or refs/tags/" + revision + " for the tag");
}

}  // namespace

bool is_commit(const std::string& text) {
  constexpr std::size_t sha1 = 40;
  constexpr std::size_t sha256 = 64;
  return (text.size() == sha1 || text.size() == sha256) &&
         text.find_first_not_of("0123456789abcdef") == std::string::npos;
}

Said listen_to(const std::vector<std::string>& command, const fs::path& directory,
               std::chrono::milliseconds patience) {
  // Nobody is there to answer; and an address names a place, no command (ext::).
  process::Filtered found =
      process::filter({.arguments = command,
                       .directory = directory,
                       .environment = {{"GIT_TERMINAL_PROMPT", "0"},
                                       {"GIT_ALLOW_PROTOCOL", "file:git:http:https:ssh"},
                                       {"LC_ALL", "C"}},
                       .patience = patience,
                       .grace = grace,
                       .longest_output = longest_answer,
                       .errors_too = true});
  return {found.well, std::move(found.output)};
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
    const std::string commit = resolved(repository, name);
    if (commit.empty()) continue;
    if (commit != revision) reject_ambiguous(repository, revision, commit, who);
    return commit;
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
                          : git({"clone", "--quiet", "--mirror", "--", address, copy.string()});
  if (!said.well) complain(who, address, "cannot be fetched; git says: " + last_line(said.text));
}

void check_out(const std::string& repository, const std::string& commit, const fs::path& folder,
               const std::string& who) {
  fs::remove_all(folder);
  // --force: the folder may have been deleted by hand, which git still remembers as a checkout.
  const Said said =
      git({"-C", repository, "worktree", "add", "--force", "--detach", "--", folder.string(), commit});
  if (!said.well) {
    complain(who, repository,
             "commit " + commit + " cannot be checked out; git says: " + last_line(said.text));
  }
}

}  // namespace builds

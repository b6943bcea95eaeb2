#pragma once

#include <chrono>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace builds {

/// What a command printed, and whether it went well.
struct Said {
  bool well = false;
  std::string text;  ///< standard output and error; of long ones the end
};

/// Runs a program to its end and listens.
///
/// @param directory  where it works; empty: ours
/// @param patience   then it is ended, which did not go well
/// @throws process::StartError when it cannot be started
Said listen_to(const std::vector<std::string>& command, const std::filesystem::path& directory,
               std::chrono::milliseconds patience);

/// Whether a text is the full name of a commit: 40 or 64 hexadecimal digits.
bool is_commit(const std::string& text);

/// The commit that a revision names in a repository: a branch, tag or commit there,
/// or a branch of its origin.
///
/// @param who  how the message calls the team
/// @return     40 hexadecimal digits
/// @throws std::invalid_argument naming team, repository and revision, with a revision that was perhaps meant;
///         and when branch and tag of that name are different commits
std::string commit_of(const std::string& repository, const std::string& revision, const std::string& who);

/// Whether git would have to fetch it: an address, not a folder.
bool is_remote(const std::string& repository);

/// Copies a remote repository without its files; an old copy at the same place is brought up to date.
///
/// @throws std::invalid_argument naming team and repository
void mirror(const std::string& address, const std::filesystem::path& copy, const std::string& who);

/// Makes `folder` a checkout of the commit, linked to the repository (git worktree).
/// What is there already is thrown away.
///
/// @throws std::invalid_argument naming team, repository and commit
void check_out(const std::string& repository, const std::string& commit, const std::filesystem::path& folder,
               const std::string& who);

}  // namespace builds

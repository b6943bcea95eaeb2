#include "experiments/runner/program_files.h"

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

#include "experiments/process/program.h"
#include "experiments/record/checksum.h"
#include "experiments/runner/worker.h"

namespace runner {

namespace fs = std::filesystem;

namespace {

/// Under the names by which they are started or opened.
std::vector<fs::path> named_files(const record::TeamConfig& team, const std::string& who) {
  std::vector<fs::path> paths;
  try {
    paths.push_back(process::find_program(team.command.front(), team.directory));
  } catch (const process::StartError& error) {
    throw std::invalid_argument(who + ": " + error.what());
  }
  for (std::size_t i = 1; i < team.command.size(); ++i) {
    std::error_code ignored;
    const fs::path file = team.directory / team.command[i];
    if (fs::is_regular_file(file, ignored)) paths.push_back(fs::absolute(file));
  }
  return paths;
}

}  // namespace

std::vector<fs::path> team_files(const record::TeamConfig& team, const std::string& who) {
  std::vector<fs::path> paths = named_files(team, who);
  for (fs::path& path : paths) path = fs::canonical(path);
  return paths;
}

std::string hash_of(const std::string& text) { return record::checksum(text); }

ProgramFile program_file(const fs::path& path) {
  try {
    return {path, record::checksum_of_file(path)};
  } catch (const std::runtime_error& error) {
    throw std::invalid_argument(error.what());
  }
}

std::vector<ProgramFile> program_files(const schedule::Design& design) {
  std::map<fs::path, std::set<fs::path>> names;
  for (const schedule::Condition& condition : design.conditions) {
    for (const auto& [team, letter] : {std::pair{&condition.a, 'a'}, std::pair{&condition.b, 'b'}}) {
      for (const fs::path& name : named_files(*team, "condition '" + condition.name + "', team " + letter)) {
        names[fs::canonical(name)].insert(name);
      }
    }
  }
  std::vector<ProgramFile> files;
  for (const auto& [path, all] : names) {
    files.push_back(program_file(path));
    files.back().names.assign(all.begin(), all.end());
  }
  return files;
}

std::vector<ProgramFile> program_files(const schedule::Design& design, const std::string& worker) {
  std::vector<ProgramFile> files = program_files(design);
  try {
    files.push_back(program_file(process::find_program(worker)));
  } catch (const process::StartError& error) {
    throw std::invalid_argument(start_problem(error));
  }
  return files;
}

std::string experiment_hash(const schedule::Design& design, const std::vector<ProgramFile>& files,
                            const std::string& protocol) {
  return experiment_hash(schedule::canonical(design), files, protocol);
}

std::string experiment_hash(const std::string& design, const std::vector<ProgramFile>& files,
                            const std::string& protocol) {
  std::vector<std::string> hashes;
  for (const ProgramFile& file : files) hashes.push_back(file.hash);
  std::sort(hashes.begin(), hashes.end());
  std::string all = design + "\n" + protocol + "\n";
  for (const std::string& hash : hashes) all += hash + "\n";
  return hash_of(all);
}

}  // namespace runner

#include "experiments/runner/program_files.h"

#include <xxhash.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <utility>

#include "experiments/process/program.h"

namespace runner {
namespace {

namespace fs = std::filesystem;

struct FreeState {
  void operator()(XXH3_state_t* state) const { XXH3_freeState(state); }
};

std::string digits(XXH128_hash_t hash) {
  std::array<char, 33> text{};
  std::snprintf(text.data(), text.size(), "%016llx%016llx", static_cast<unsigned long long>(hash.high64),
                static_cast<unsigned long long>(hash.low64));
  return text.data();
}

}  // namespace

std::vector<fs::path> team_files(const record::TeamConfig& team, const std::string& who) {
  std::vector<fs::path> paths;
  try {
    paths.push_back(fs::canonical(process::find_program(team.command.front(), team.directory)));
  } catch (const process::StartError& error) {
    throw std::invalid_argument(who + ": " + error.what());
  }
  for (std::size_t i = 1; i < team.command.size(); ++i) {
    std::error_code ignored;
    const fs::path file = team.directory / team.command[i];
    if (fs::is_regular_file(file, ignored)) paths.push_back(fs::canonical(file));
  }
  return paths;
}

std::string hash_of(const std::string& text) { return digits(XXH3_128bits(text.data(), text.size())); }

ProgramFile program_file(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw std::invalid_argument(path.string() + ": cannot be read");
  const std::unique_ptr<XXH3_state_t, FreeState> state(XXH3_createState());
  XXH3_128bits_reset(state.get());
  std::array<char, 65536> buffer;
  while (stream) {
    stream.read(buffer.data(), buffer.size());
    XXH3_128bits_update(state.get(), buffer.data(), static_cast<std::size_t>(stream.gcount()));
  }
  return {path, digits(XXH3_128bits_digest(state.get()))};
}

std::vector<ProgramFile> program_files(const schedule::Design& design) {
  std::vector<fs::path> paths;
  for (const schedule::Condition& condition : design.conditions) {
    for (const auto& [team, letter] : {std::pair{&condition.a, 'a'}, std::pair{&condition.b, 'b'}}) {
      const auto found = team_files(*team, "condition '" + condition.name + "', team " + letter);
      paths.insert(paths.end(), found.begin(), found.end());
    }
  }
  std::sort(paths.begin(), paths.end());
  paths.erase(std::unique(paths.begin(), paths.end()), paths.end());
  std::vector<ProgramFile> files;
  for (const fs::path& path : paths) files.push_back(program_file(path));
  return files;
}

std::string experiment_hash(const schedule::Design& design, const std::vector<ProgramFile>& files,
                            const std::string& protocol) {
  std::vector<std::string> hashes;
  for (const ProgramFile& file : files) hashes.push_back(file.hash);
  std::sort(hashes.begin(), hashes.end());
  std::string all = schedule::canonical(design) + "\n" + protocol + "\n";
  for (const std::string& hash : hashes) all += hash + "\n";
  return hash_of(all);
}

}  // namespace runner

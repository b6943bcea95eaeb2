#include "experiments/isolation.h"

#include <stdexcept>

namespace commands {

namespace fs = std::filesystem;
using process::Isolation;

std::optional<Isolation> asked_isolation(const std::string& word) {
  if (word.empty()) return std::nullopt;
  const auto level = process::isolation_from_name(word);
  if (!level) {
    throw std::invalid_argument("--isolation " + word +
                                ": there is no such level; known are: none, files, network");
  }
  return level;
}

ChosenIsolation chosen_isolation(std::optional<Isolation> asked, const std::string& asked_by) {
  if (asked == Isolation::None) return {Isolation::None, "isolation none, as asked for"};
  const process::IsolationLimit limit = process::isolation_limit();
  if (asked && *asked > limit.strongest) {
    throw std::invalid_argument(asked_by + " " + process::name(*asked) + ": this machine allows only '" +
                                process::name(limit.strongest) + "': " + limit.problem +
                                "; mend that, or ask for less");
  }
  const Isolation level = asked.value_or(limit.strongest);
  std::string sentence = std::string("isolation ") + process::name(level);
  if (asked) {
    sentence += ", as asked for";
  } else if (!limit.problem.empty()) {
    sentence += ", no more is possible here: " + limit.problem;
  }
  if (level != Isolation::None && !limit.gap.empty()) sentence += ", but " + limit.gap;
  return {level, sentence};
}

std::vector<fs::path> visible_paths(const std::vector<fs::path>& paths, const std::string& asked_by) {
  std::vector<fs::path> found;
  for (const fs::path& path : paths) {
    std::error_code error;
    found.push_back(fs::canonical(path, error));
    if (error) {
      throw std::invalid_argument(asked_by + " " + path.string() + ": there is no such file or folder");
    }
  }
  return found;
}

host::Options isolated_game(const IsolationOptions& options, std::string* sentence) {
  const ChosenIsolation chosen = chosen_isolation(asked_isolation(options.level), "--isolation");
  if (sentence != nullptr) *sentence = chosen.sentence;
  host::Options settings;
  settings.isolation = chosen.level;
  settings.visible = visible_paths(options.visible, "--visible");
  return settings;
}

host::Options game_as_told(const IsolationOptions& options, const std::vector<fs::path>& hidden) {
  host::Options settings;
  settings.isolation = asked_isolation(options.level).value_or(Isolation::None);
  settings.visible = options.visible;
  settings.hidden = hidden;
  return settings;
}

std::vector<std::string> worker_flags(Isolation level, const std::vector<fs::path>& visible,
                                      const fs::path& hidden) {
  std::vector<std::string> flags = {"--isolation", process::name(level)};
  if (level == Isolation::None) return flags;
  flags.insert(flags.end(), {"--hide", fs::weakly_canonical(fs::absolute(hidden)).string()});
  for (const fs::path& path : visible) flags.insert(flags.end(), {"--visible", path.string()});
  return flags;
}

}  // namespace commands

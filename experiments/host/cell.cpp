#include "experiments/host/cell.h"

#include <algorithm>
#include <string>

#include "experiments/host/messages.h"

namespace host {

process::Cell cell_of(world::Team team, const record::MatchConfig& config, const Options& options) {
  process::Cell cell;
  cell.level = options.isolation;
  if (cell.level == process::Isolation::None) return cell;

  const record::TeamConfig& own = config.teams[team];
  const record::TeamConfig& other = config.teams[world::opponent(team)];
  const auto needed = process::needed_folders(own.command, own.directory);
  const auto hide = [&](const std::vector<std::filesystem::path>& folders) {
    for (const auto& folder : process::not_shared(folders, needed, own.directory))
      cell.hidden.push_back(folder);
  };
  cell.hidden = options.hidden;
  hide(process::needed_folders(other.command, other.directory));
  hide({std::filesystem::temp_directory_path()});
  if (!config.directory.empty()) {
    hide({std::filesystem::absolute(config.directory)});
    const std::string others = log_folder(world::opponent(team), config).string();
    const auto holds_it = [&](const auto& folder) { return others.starts_with(folder.string() + "/"); };
    if (std::none_of(cell.hidden.begin(), cell.hidden.end(), holds_it)) cell.hidden.emplace_back(others);
    cell.writable = {log_folder(team, config)};
  }
  cell.visible = options.visible;
  return cell;
}

}  // namespace host

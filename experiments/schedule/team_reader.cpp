#include "experiments/schedule/team_reader.h"

#include <algorithm>
#include <stdexcept>

#include "experiments/schedule/command_line.h"
#include "experiments/schedule/names.h"
#include "sim/console/printable.h"
#include "sim/world/robot_id.h"

namespace schedule {
namespace {

/// `command = "program --flag"` or `["program", "--flag"]`.
void read_command(TomlTable& table, const std::string& key, std::vector<std::string>& command) {
  if (table.is_text(key)) {
    try {
      command = split_command(*table.text(key));
    } catch (const std::invalid_argument& error) {
      table.reject(key, error.what());
    }
  } else if (auto words = table.texts(key)) {
    if (words->empty() || words->front().empty()) table.reject(key, "must begin with a program");
    command = std::move(*words);
  }
}

/// An argument for git: it must not be read as an option, and has its place in a line of a file.
std::string git_word(TomlTable& table, const std::string& key) {
  const auto text = table.text(key);
  if (text && text->empty()) table.reject(key, "must not be empty");
  if (text && text->front() == '-') {
    table.reject(key, "must not begin with '-', which git takes for an option");
  }
  if (text && console::printable(*text) != *text) table.reject(key, "must not have control characters");
  return text.value_or("");
}

/// Repository, revision, build and run, over what is known already.
void read_source(TomlTable& table, Team& team) {
  const bool names_one = table.has("repository");
  if (names_one && !team.source) team.source.emplace();
  if (!team.source) {
    for (const char* key : {"revision", "build", "run"}) {
      if (table.has(key)) table.reject(key, "belongs to a team from git; give its repository too");
    }
  }
  // Also when there is no source: they are keys a team may have.
  const std::string repository = git_word(table, "repository");
  const std::string revision = git_word(table, "revision");
  if (repository.find("::") != std::string::npos) {
    table.reject("repository",
                 "must be a path or an address; with '::' git would run a program of that name");
  }
  const auto build = table.text("build");
  if (table.has("run") && table.has("command"))
    table.reject("command", "give either command or run, not both");
  read_command(table, "run", team.config.command);
  if (!team.source) return;
  if (names_one) team.source->repository = repository;
  if (!revision.empty()) team.source->revision = revision;
  if (build) team.source->build = *build;
}

void read_robots(TomlTable& table, record::TeamConfig& team, std::size_t most) {
  if (table.is_integer("robots")) {
    const std::int64_t count = *table.integer("robots");
    if (count < 1 || static_cast<std::size_t>(count) > team.robots.size()) {
      table.reject("robots", "must be from 1 to " + std::to_string(team.robots.size()) +
                                 ", or a list of their numbers");
    }
    team.robots.resize(static_cast<std::size_t>(count));
    return;
  }
  const auto numbers = table.integers("robots");
  if (!numbers) return;
  if (numbers->empty() || numbers->size() > most) {
    table.reject("robots", "must name 1 to " + std::to_string(most) + " robots");
  }
  team.robots.clear();
  for (const std::int64_t number : *numbers) {
    if (number < 0 || number > world::max_robot_number) {
      table.reject("robots", "robots have numbers from 0 to " + std::to_string(world::max_robot_number));
    }
    const int robot = static_cast<int>(number);
    if (std::find(team.robots.begin(), team.robots.end(), robot) != team.robots.end()) {
      table.reject("robots", "names robot " + std::to_string(robot) + " twice");
    }
    team.robots.push_back(robot);
  }
}

/// Reads what the table says about a team over what `team` says already.
void read_over(TomlTable& table, Team& team, std::size_t most_robots) {
  record::TeamConfig& config = team.config;
  read_command(table, "command", config.command);
  read_source(table, team);
  if (team.source && table.has("command")) {
    table.reject("command", "this team is built from git; give its command as run = \"...\"");
  }
  if (const auto name = table.text("name")) {
    check_team_name(table, "name", *name);
    config.name = *name;
  }
  read_robots(table, config, most_robots);
  if (const auto factor = table.number("speed_factor")) {
    if (!(*factor > 0 && *factor <= 1)) table.reject("speed_factor", "must be above 0 and at most 1");
    config.speed_factor = *factor;
  }
}

/// `flags."--press" = 0.5` gives --press=0.5; `flags."-p {}" = 0.5` gives -p 0.5.
void read_flags(TomlTable& table, std::vector<std::string>& command) {
  auto flags = table.table("flags");
  if (!flags) return;
  for (const std::string& flag : flags->keys()) {
    const std::string value = *flags->word(flag);
    const std::size_t hole = flag.find("{}");
    if (hole == std::string::npos) {
      command.push_back(flag + "=" + value);
      continue;
    }
    try {
      for (std::string& word : split_command(flag)) {
        const std::size_t at = word.find("{}");
        if (at != std::string::npos) word.replace(at, 2, value);
        command.push_back(word);
      }
    } catch (const std::invalid_argument& error) {
      flags->reject(flag, error.what());
    }
  }
}

}  // namespace

Team read_team(TomlTable& table, std::size_t most_robots) {
  Team team;
  read_over(table, team, most_robots);
  if (team.source) {
    if (team.source->revision.empty()) table.missing("revision", "give a branch, tag or commit");
    if (team.config.command.empty())
      table.missing("run", "as run = \"build/my-team\", seen from the checkout");
    if (team.config.name.empty()) team.config.name = console::shortened(team.source->revision, longest_name);
  }
  if (team.config.command.empty()) {
    table.missing("command",
                  "as command = [\"team-reference\"]; or give repository, revision, build and run");
  }
  if (team.config.name.empty()) {
    team.config.name = console::shortened(console::printable(usual_name(team.config.command)), longest_name);
  }
  table.finish();
  return team;
}

void change_team(TomlTable& condition, const std::string& key, Team& team, std::size_t most_robots) {
  auto table = condition.table(key);
  if (!table) return;
  read_over(*table, team, most_robots);
  if (const auto arguments = table->texts("arguments")) {
    team.config.command.insert(team.config.command.end(), arguments->begin(), arguments->end());
  }
  read_flags(*table, team.config.command);
  table->finish();
}

}  // namespace schedule

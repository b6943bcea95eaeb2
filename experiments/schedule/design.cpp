#include "experiments/schedule/design.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "experiments/schedule/command_line.h"
#include "experiments/schedule/toml_reader.h"
#include "sim/world/rules/rule_set.h"

namespace schedule {
namespace {

constexpr std::int64_t most_pairs = 100'000;  // ours: two hundred thousand games are some weeks of a laptop
// Two halves, each with the longest overrun, must stay below the host's 40 minutes (DESIGN, "Clock").
constexpr double longest_half = 1'100;  // [s]
constexpr std::int64_t most_forfeit_goals = 100;

constexpr const char* name_hint = "use letters, digits, '-', '_' and '.' only, since it names files";

bool names_files(const std::string& name) {
  const auto usual = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '_' || c == '.';
  };
  return !name.empty() && name.front() != '.' && std::all_of(name.begin(), name.end(), usual);
}

template <class Names>
std::string listed(const Names& names) {
  std::string list;
  for (const std::string_view name : names) list += (list.empty() ? "" : ", ") + std::string(name);
  return list;
}

/// The name of a preset or rule set, one of `known`.
template <class Names>
void check_known(const TomlTable& table, const std::string& key, const std::string& value,
                 const Names& known) {
  if (std::find(known.begin(), known.end(), value) == known.end()) {
    table.reject(key, "there is no such one; known are: " + listed(known));
  }
}

void read_robots(TomlTable& table, record::TeamConfig& team, std::size_t most) {
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
void read_team(TomlTable& table, record::TeamConfig& team, std::size_t most_robots) {
  if (table.is_text("command")) {
    try {
      team.command = split_command(*table.text("command"));
    } catch (const std::invalid_argument& error) {
      table.reject("command", error.what());
    }
  } else if (auto words = table.texts("command")) {
    if (words->empty() || words->front().empty()) table.reject("command", "must begin with a program");
    team.command = std::move(*words);
  }
  if (const auto name = table.text("name")) {
    if (name->empty() || name->find('\n') != std::string::npos)
      table.reject("name", "must be one line of text");
    team.name = *name;
  }
  read_robots(table, team, most_robots);
  if (const auto factor = table.number("speed_factor")) {
    if (!(*factor > 0 && *factor <= 1)) table.reject("speed_factor", "must be above 0 and at most 1");
    team.speed_factor = *factor;
  }
}

/// One of [teams.a] and [teams.b].
record::TeamConfig base_team(TomlTable& teams, const std::string& key, std::size_t most_robots) {
  auto table = teams.table(key);
  if (!table) teams.missing(key, "give both teams, as [teams.a] and [teams.b] with a command each");
  record::TeamConfig team;
  read_team(*table, team, most_robots);
  if (team.command.empty()) table->missing("command", "as command = [\"team-reference\"]");
  if (team.name.empty()) team.name = std::filesystem::path(team.command.front()).filename().string();
  table->finish();
  return team;
}

/// What a condition changes of one team.
void override_team(TomlTable& condition, const std::string& key, record::TeamConfig& team,
                   std::size_t most_robots) {
  auto table = condition.table(key);
  if (!table) return;
  read_team(*table, team, most_robots);
  if (const auto arguments = table->texts("arguments")) {
    team.command.insert(team.command.end(), arguments->begin(), arguments->end());
  }
  table->finish();
}

/// `realism = "harsh"`, or a table [realism] with `preset = "harsh"` and numbers by their keys; over
/// `realism`.
void read_realism(TomlTable& root, const CheckRealism& check, record::RealismConfig& realism) {
  const auto checked = [&](TomlTable& table, const std::string& key) {
    try {
      if (check) check(realism);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(table.place(key) + ": " + error.what());
    }
  };
  if (root.is_text("realism")) {
    realism = {*root.text("realism"), {}};
    checked(root, "realism");
    return;
  }
  auto table = root.table("realism");
  if (!table) return;
  if (const auto preset = table->text("preset")) {
    realism = {*preset, {}};
    checked(*table, "preset");
  }
  table->numbers([&](const std::string& name, double value, TomlTable& place, const std::string& key) {
    realism.changes[name] = value;
    checked(place, key);
  });
}

void read_conditions(TomlTable& root, const record::TeamConfig& a, const record::TeamConfig& b,
                     std::size_t most_robots, const CheckRealism& check, Design& design) {
  auto tables = root.tables("conditions");
  if (!tables) {
    design.conditions.push_back({"base", a, b, design.realism});
    return;
  }
  if (tables->empty())
    root.reject("conditions", "must have at least one, as [[conditions]]; or leave it out");
  for (TomlTable& table : *tables) {
    Condition condition{"", a, b, design.realism};
    const auto name = table.text("name");
    if (!name) table.missing("name", "give every condition a name of its own");
    if (!names_files(*name)) table.reject("name", name_hint);
    for (const Condition& other : design.conditions) {
      if (other.name == *name) table.reject("name", "another condition has that name already");
    }
    condition.name = *name;
    override_team(table, "a", condition.a, most_robots);
    override_team(table, "b", condition.b, most_robots);
    read_realism(table, check, condition.realism);
    table.finish();
    design.conditions.push_back(std::move(condition));
  }
}

void read_size(TomlTable& root, Design& design) {
  const auto pairs = root.integer("pairs");
  const auto games = root.integer("games");
  if (pairs && games) root.reject("games", "give either pairs or games, not both");
  if (!pairs && !games)
    root.missing("pairs", "give the number of pairs (or games) of each condition, as pairs = 20");
  if (games && (*games < 2 || *games > 2 * most_pairs || *games % 2 != 0)) {
    root.reject("games",
                "must be even, since games come in pairs with the colours exchanged, and from 2 to " +
                    std::to_string(2 * most_pairs));
  }
  if (pairs && (*pairs < 1 || *pairs > most_pairs)) {
    root.reject("pairs", "must be from 1 to " + std::to_string(most_pairs));
  }
  design.pairs = static_cast<int>(pairs ? *pairs : *games / 2);
}

void read_rules(TomlTable& root, Design& design) {
  auto table = root.table("rules");
  if (!table) return;
  if (const auto set = table->text("set")) {
    check_known(*table, "set", *set, world::rule_set_names());
    design.rules = *set;
  }
  if (const auto half = table->number("half_length")) {
    if (!(*half >= 1 && *half <= longest_half)) {
      table->reject("half_length", "must be from 1 to 1100 seconds");
    }
    design.half_length = *half;
  }
  if (const auto winner = table->boolean("winner")) design.winner = *winner;
  table->finish();
}

std::string text_of(const std::filesystem::path& file, const std::string& wanted) {
  std::ifstream stream(file);
  if (!stream || std::filesystem::is_directory(file)) {
    throw std::invalid_argument(file.string() + ": cannot be read; give the path of " + wanted);
  }
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

}  // namespace

Design parse_design(const std::string& text, const std::string& file, const CheckRealism& check) {
  TomlTable root = TomlTable::parse(text, file);
  Design design;
  design.text = text;

  const auto name = root.text("name");
  if (!name) root.missing("name", "give the experiment a name, as name = \"first-night\"");
  if (!names_files(*name)) root.reject("name", name_hint);
  design.name = *name;
  design.description = root.text("description").value_or("");
  if (const auto seed = root.integer("seed")) {
    if (*seed < 0) root.reject("seed", "must not be negative");
    design.seed = static_cast<std::uint64_t>(*seed);
  }
  read_size(root, design);
  read_rules(root, design);
  read_realism(root, check, design.realism);
  if (const auto goals = root.integer("forfeit_goals")) {
    if (*goals < 1 || *goals > most_forfeit_goals) root.reject("forfeit_goals", "must be from 1 to 100");
    design.forfeit_goals = static_cast<int>(*goals);
  }

  const auto most_robots = static_cast<std::size_t>(world::rule_set(design.rules).robots_per_team);
  auto teams = root.table("teams");
  if (!teams) root.missing("teams", "give both teams, as [teams.a] and [teams.b] with a command each");
  const record::TeamConfig a = base_team(*teams, "a", most_robots);
  const record::TeamConfig b = base_team(*teams, "b", most_robots);
  teams->finish();
  read_conditions(root, a, b, most_robots, check, design);
  root.finish();
  return design;
}

Design read_design(const std::filesystem::path& file, const CheckRealism& check) {
  return parse_design(text_of(file, "a design file, as experiments/designs/first-night.toml"), file.string(),
                      check);
}

record::RealismConfig read_realism(const std::filesystem::path& file, const CheckRealism& check) {
  TomlTable root = TomlTable::parse(text_of(file, "a TOML file with a table [realism]"), file.string());
  if (!root.has("realism")) root.missing("realism", "give a table [realism] with a preset and numbers");
  record::RealismConfig realism;
  read_realism(root, check, realism);
  return realism;
}

}  // namespace schedule

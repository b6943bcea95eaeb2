#include "experiments/schedule/design.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "experiments/schedule/names.h"
#include "experiments/schedule/nearest.h"
#include "experiments/schedule/run_reader.h"
#include "experiments/schedule/team_reader.h"
#include "experiments/schedule/toml_reader.h"
#include "sim/files/regular_file.h"
#include "sim/world/rules/rule_set.h"

namespace schedule {
namespace {

constexpr std::int64_t most_pairs = 100'000;  // ours: two hundred thousand games are some weeks of a laptop
constexpr std::int64_t most_forfeit_goals = 100;
constexpr std::size_t most_conditions = 1'000;              // ours: a grid of more is a slip of the pen
constexpr std::size_t longest_description = 10'000;         // [bytes] ours: some pages of text
constexpr std::size_t largest_file = std::size_t{1} << 20;  // [bytes] ours: the largest design here has 3 kB

constexpr std::string_view only_condition = "base";

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
    table.reject(key, "there is no such one" + did_you_mean(value, {known.begin(), known.end()}) +
                          "; known are: " + listed(known));
  }
}

/// `realism = "harsh"`, or a table [realism] with `preset = "harsh"` and numbers by
/// their keys; over `realism`.
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

/// What conditions are made from.
struct Setting {
  Team a;
  Team b;
  std::size_t most_robots;
  const CheckRealism& check;
};

/// What `table` says of a condition, over the teams and realism of the design.
Condition read_condition(TomlTable& table, const Setting& setting, const Design& design) {
  Team a = setting.a;
  Team b = setting.b;
  Condition condition;
  condition.realism = design.realism;
  const auto name = table.text("name");
  if (!name) table.missing("name", "give every condition and sweep a name of its own");
  check_file_name(table, "name", *name);
  condition.name = *name;
  change_team(table, "a", a, setting.most_robots);
  change_team(table, "b", b, setting.most_robots);
  read_realism(table, setting.check, condition.realism);
  table.finish();
  condition.a = a.config;
  condition.b = b.config;
  condition.a_source = a.source;
  condition.b_source = b.source;
  return condition;
}

void add_condition(const TomlTable& table, const std::string& key, Condition condition, Design& design) {
  for (const Condition& other : design.conditions) {
    if (other.name == condition.name) {
      table.reject(key, "another condition has the name '" + condition.name + "' already");
    }
  }
  if (condition.name.size() > longest_name) {  // made of a sweep's or panel's name and its values
    table.reject(key, "makes a condition whose name has " + std::to_string(condition.name.size()) +
                          " characters, '" + condition.name.substr(0, longest_name) + "...'; at most " +
                          std::to_string(longest_name) + " are possible");
  }
  if (design.conditions.size() >= most_conditions) {
    table.reject(key, "makes more than " + std::to_string(most_conditions) + " conditions");
  }
  design.conditions.push_back(std::move(condition));
}

void read_conditions(TomlTable& root, const Setting& setting, Design& design) {
  auto tables = root.tables("conditions");
  if (!tables) return;
  if (tables->empty()) {
    root.reject("conditions", "must have at least one, as [[conditions]]; or leave it out");
  }
  for (TomlTable& table : *tables) {
    add_condition(table, "name", read_condition(table, setting, design), design);
  }
}

/// A piece of a condition's name.
std::string file_word(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return !names_files("x" + std::string(1, c)); }, '-');
  return text;
}

/// One condition for each choice of an element from each list of the sweep, the last list running fastest.
void read_sweep(TomlTable& table, const Setting& setting, Design& design) {
  const std::vector<TomlAxis> axes = table.axes();
  if (axes.empty()) {
    if (table.has("name"))
      table.reject("name", "sweeps nothing; give a list, as b.speed_factor = [0.3, 0.5, 0.7]");
    table.missing("name", "give every condition and sweep a name of its own");
  }
  std::vector<std::size_t> at(axes.size(), 0);
  for (bool more = true; more;) {
    TomlTable point = table.point(at);
    Condition condition = read_condition(point, setting, design);
    condition.sweep = condition.name;
    for (std::size_t i = 0; i < axes.size(); ++i) {
      const TomlAxis::Element& element = axes[i].elements[at[i]];
      condition.name += "-" + file_word(element.label);
      std::string key = axes[i].name;
      const std::size_t flags = key.find(".flags.");
      if (flags != std::string::npos) key.erase(flags, std::string_view(".flags").size());
      if (element.number) condition.values[key] = *element.number;
    }
    add_condition(table, "name", std::move(condition), design);
    more = false;
    for (std::size_t i = axes.size(); i-- > 0 && !more;) {
      more = ++at[i] < axes[i].elements.size();
      if (!more) at[i] = 0;
    }
  }
}

/// Writes a panel out: in the place of each condition A and B meet each opponent under it, in the same pairs.
void read_panel(TomlTable& root, const Setting& setting, Design& design) {
  auto panel = root.table("panel");
  if (!panel) return;
  const bool head_to_head = panel->boolean("head_to_head").value_or(false);
  auto opponents = panel->tables("opponents");
  if (!opponents || opponents->empty()) {
    panel->missing("opponents", "give each opponent of A and B as [[panel.opponents]]");
  }
  const std::vector<Condition> bases = std::exchange(design.conditions, {});
  const bool named = bases.size() > 1 || bases.front().name != only_condition;
  std::vector<Team> teams;
  for (TomlTable& table : *opponents) {
    Team team = read_team(table, setting.most_robots);
    if (table.has("name")) check_file_name(table, "name", team.config.name);
    if (!names_files(team.config.name))
      table.missing("name", "use letters, digits, '-', '_' and '.' only, since it names files");
    teams.push_back(std::move(team));
  }
  panel->finish();
  for (const Condition& base : bases) {
    const std::string prefix = named ? base.name + "-" : "";
    if (head_to_head) {
      Condition direct = base;
      direct.name = prefix + "a-vs-b";
      add_condition(root, "panel", std::move(direct), design);
    }
    for (const Team& team : teams) {
      for (const char arm : {'a', 'b'}) {
        Condition condition = base;
        condition.name = prefix + std::string(1, arm) + "-vs-" + team.config.name;
        condition.panel = PanelPlace{base.name, team.config.name, arm};
        if (arm == 'b') {
          condition.a = base.b;
          condition.a_source = base.b_source;
        }
        condition.b = team.config;
        condition.b_source = team.source;
        add_condition(root, "panel", std::move(condition), design);
      }
    }
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

void read_isolation(TomlTable& root, Design& design) {
  if (const auto level = root.text("isolation")) {
    check_known(root, "isolation", *level, std::vector<std::string>{"none", "files", "network"});
    design.isolation = process::isolation_from_name(*level);
  }
  if (const auto paths = root.texts("visible")) design.visible.assign(paths->begin(), paths->end());
}

std::string text_of(const std::filesystem::path& file, const std::string& wanted) {
  try {
    return files::text_of(file, largest_file);
  } catch (const std::runtime_error& error) {
    throw std::invalid_argument(std::string(error.what()) + "; give the path of " + wanted);
  }
}

}  // namespace

Design parse_design(const std::string& text, const std::string& file, const CheckRealism& check) {
  TomlTable root = TomlTable::parse(text, file);
  Design design;
  design.text = text;

  const auto name = root.text("name");
  if (!name) root.missing("name", "give the experiment a name, as name = \"first-night\"");
  check_file_name(root, "name", *name);
  design.name = *name;
  design.description = root.text("description").value_or("");
  if (design.description.size() > longest_description) {
    root.reject("description", "has more than " + std::to_string(longest_description) + " bytes");
  }
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
  design.stopping = read_stopping(root, design.pairs);
  design.limits = read_limits(root);
  read_isolation(root, design);

  const auto most_robots = static_cast<std::size_t>(world::rule_set(design.rules).robots_per_team);
  auto teams = root.table("teams");
  if (!teams) root.missing("teams", "give both teams, as [teams.a] and [teams.b] with a command each");
  const auto base_team = [&](const char* key) {
    auto table = teams->table(key);
    if (!table) teams->missing(key, "give both teams, as [teams.a] and [teams.b] with a command each");
    return read_team(*table, most_robots);
  };
  Team a = base_team("a");
  Team b = base_team("b");
  const Setting setting{std::move(a), std::move(b), most_robots, check};
  teams->finish();
  read_conditions(root, setting, design);
  if (auto sweeps = root.tables("sweeps")) {
    for (TomlTable& sweep : *sweeps) read_sweep(sweep, setting, design);
  }
  if (design.conditions.empty()) {
    design.conditions.push_back({std::string(only_condition), setting.a.config, setting.b.config,
                                 design.realism, setting.a.source, setting.b.source});
  }
  read_panel(root, setting, design);
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

#include "experiments/schedule/toml_reader.h"

#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "experiments/schedule/nearest.h"
#include "experiments/schedule/toml_depth.h"

namespace schedule {
namespace {

constexpr std::size_t longest_value = 60;  // of a value in a message

std::string listed(const std::vector<std::string>& words) {
  std::string list;
  for (const std::string& word : words) list += (list.empty() ? "" : ", ") + word;
  return list;
}

/// The shortest decimal that reads back as the same number: 0.3, 5, 1e-05.
std::string shortest(double value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

/// What a value looks like on a command line; nothing for tables, lists and dates.
std::optional<std::string> word_of(const toml::node& node) {
  if (node.is_string()) return *node.value_exact<std::string>();
  if (node.is_boolean()) return *node.value_exact<bool>() ? "true" : "false";
  if (node.is_integer()) return std::to_string(*node.value_exact<std::int64_t>());
  if (node.is_floating_point()) return shortest(*node.value_exact<double>());
  return std::nullopt;
}

/// As a double, rounded: toml++'s own conversion gives nothing for a whole number that no double is.
double number_of(const toml::node& node) {
  if (node.is_integer()) return static_cast<double>(*node.value_exact<std::int64_t>());
  return *node.value_exact<double>();
}

std::string shown(const toml::node& node) {
  if (node.is_table()) return "{...}";
  if (node.is_array() && !node.as_array()->empty() && node.as_array()->get(0)->is_table()) return "[{...}]";
  if (node.is_number()) return *word_of(node);
  std::ostringstream out;
  out << toml::node_view<const toml::node>(&node);
  std::string value = out.str();
  std::replace(value.begin(), value.end(), '\n', ' ');
  if (value.size() > longest_value) value = value.substr(0, longest_value) + "...";
  return value;
}

struct List {
  std::string name;
  const toml::array* array;
};

bool before(const toml::source_position& one, const toml::source_position& other) {
  return std::pair(one.line, one.column) < std::pair(other.line, other.column);
}

void collect_lists(const toml::table& table, const std::string& path, std::vector<List>& lists) {
  for (const auto& [key, node] : table) {
    const std::string name(key.str());
    const std::string full = path.empty() ? name : path + "." + name;
    if (const toml::table* inside = node.as_table()) collect_lists(*inside, full, lists);
    const toml::array* array = node.as_array();
    if (array == nullptr) continue;
    const bool holds_a_list = name == "command" || name == "arguments" || name == "run";
    if (holds_a_list && !(!array->empty() && array->get(0)->is_array())) continue;
    lists.push_back({full, array});
  }
}

/// The axes of a table in the file's order.
std::vector<List> lists_of(const toml::table& table) {
  std::vector<List> lists;
  collect_lists(table, "", lists);
  std::stable_sort(lists.begin(), lists.end(), [](const List& one, const List& other) {
    return before(one.array->source().begin, other.array->source().begin);
  });
  return lists;
}

}  // namespace

struct TomlTable::Node {
  std::shared_ptr<const toml::table> root;  // keeps `table` alive
  const toml::table* table = nullptr;
  std::string file;
  std::string path;                                         // "teams.a"; empty at the root
  std::map<const toml::node*, const toml::node*> chosen{};  // elements that stand for their lists

  const toml::node* get(const std::string& key) const {
    const toml::node* node = table->get(key);
    const auto element = chosen.find(node);
    return element == chosen.end() ? node : element->second;
  }

  Node inside(const toml::table& inner, const std::string& its_path) const {
    Node node = *this;
    node.table = &inner;
    node.path = its_path;
    return node;
  }

  std::string place(const toml::source_region& source) const {
    return file + ":" + std::to_string(source.begin.line);
  }
};

TomlTable TomlTable::parse(const std::string& text, const std::string& file) {
  if (const auto line = too_deep(text)) {
    throw std::invalid_argument(file + ":" + std::to_string(*line) + ": tables or lists are more than " +
                                std::to_string(deepest) + " deep inside each other");
  }
  try {
    auto root = std::make_shared<const toml::table>(toml::parse(text, file));
    const toml::table* table = root.get();
    return TomlTable(std::make_shared<const Node>(Node{std::move(root), table, file, ""}));
  } catch (const toml::parse_error& error) {
    throw std::invalid_argument(file + ":" + std::to_string(error.source().begin.line) +
                                ": not TOML: " + std::string(error.description()));
  }
}

std::string TomlTable::full_name(const std::string& key) const {
  return node_->path.empty() ? key : node_->path + "." + key;
}

bool TomlTable::has(const std::string& key) const { return node_->table->contains(key); }
bool TomlTable::is_text(const std::string& key) const {
  const toml::node* node = node_->get(key);
  return node != nullptr && node->is_string();
}

bool TomlTable::is_integer(const std::string& key) const {
  const toml::node* node = node_->get(key);
  return node != nullptr && node->is_integer();
}

std::vector<std::string> TomlTable::keys() const {
  std::vector<std::pair<toml::source_position, std::string>> found;
  for (const auto& [key, node] : *node_->table)
    found.emplace_back(key.source().begin, std::string(key.str()));
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& one, const auto& other) { return before(one.first, other.first); });
  std::vector<std::string> names;
  for (auto& [position, name] : found) names.push_back(std::move(name));
  return names;
}

std::vector<TomlAxis> TomlTable::axes() const {
  std::vector<TomlAxis> axes;
  for (const List& list : lists_of(*node_->table)) {
    const auto complain = [&](const toml::node& node, const std::string& problem) {
      throw std::invalid_argument(node_->place(node.source()) + ": " + full_name(list.name) + " = " +
                                  shown(node) + ": " + problem);
    };
    if (list.array->empty()) complain(*list.array, "must have at least one value to take");
    TomlAxis axis{list.name, {}};
    for (const toml::node& element : *list.array) {
      const std::optional<std::string> word = word_of(element);
      if (word) {
        axis.elements.push_back(
            {*word, element.is_number() ? std::optional(number_of(element)) : std::nullopt});
      } else if (const toml::array* many = element.as_array()) {
        axis.elements.push_back(
            {std::to_string(axis.elements.size() + 1), static_cast<double>(many->size())});
      } else {
        complain(element, "must be a number, a text, true, false or a list");
      }
    }
    axes.push_back(std::move(axis));
  }
  return axes;
}

TomlTable TomlTable::point(const std::vector<std::size_t>& elements) const {
  Node node = *node_;
  const std::vector<List> lists = lists_of(*node_->table);
  for (std::size_t i = 0; i < lists.size(); ++i)
    node.chosen[lists[i].array] = lists[i].array->get(elements[i]);
  return TomlTable(std::make_shared<const Node>(std::move(node)));
}

std::string TomlTable::place(const std::string& key) const { return node_->place(node_->get(key)->source()); }

void TomlTable::reject(const std::string& key, const std::string& problem) const {
  const toml::node* node = node_->get(key);
  throw std::invalid_argument(place(key) + ": " + full_name(key) + " = " + shown(*node) + ": " + problem);
}

void TomlTable::missing(const std::string& key, const std::string& hint) const {
  // Perhaps it is there under a misspelt name: then that name and its line are the news.
  std::vector<std::string> absent{key};
  for (const std::string& name : known_) {
    if (!has(name)) absent.push_back(name);
  }
  for (const std::string& name : keys()) {
    constexpr std::size_t letter = 2;  // of a and b each is near the other
    const bool asked = std::find(known_.begin(), known_.end(), name) != known_.end();
    if (asked || name.size() <= letter) continue;
    if (const std::string meant = did_you_mean(name, absent); !meant.empty()) {
      throw std::invalid_argument(place(name) + ": unknown key " + full_name(name) + " = " +
                                  shown(*node_->get(name)) + meant);
    }
  }
  throw std::invalid_argument(node_->place(node_->table->source()) + ": " + full_name(key) + " is missing; " +
                              hint);
}

std::optional<std::string> TomlTable::text(const std::string& key) {
  known_.push_back(key);
  const toml::node* node = node_->get(key);
  if (node == nullptr) return std::nullopt;
  if (!node->is_string()) reject(key, "must be a text in quotes");
  return node->value_exact<std::string>();
}

std::optional<std::int64_t> TomlTable::integer(const std::string& key) {
  known_.push_back(key);
  const toml::node* node = node_->get(key);
  if (node == nullptr) return std::nullopt;
  if (!node->is_integer()) reject(key, "must be a whole number");
  return node->value_exact<std::int64_t>();
}

std::optional<bool> TomlTable::boolean(const std::string& key) {
  known_.push_back(key);
  const toml::node* node = node_->get(key);
  if (node == nullptr) return std::nullopt;
  if (!node->is_boolean()) reject(key, "must be true or false");
  return node->value_exact<bool>();
}

std::optional<double> TomlTable::number(const std::string& key) {
  known_.push_back(key);
  const toml::node* node = node_->get(key);
  if (node == nullptr) return std::nullopt;
  if (!node->is_number()) reject(key, "must be a number");
  return number_of(*node);
}

std::optional<std::string> TomlTable::word(const std::string& key) {
  known_.push_back(key);
  const toml::node* node = node_->get(key);
  if (node == nullptr) return std::nullopt;
  auto word = word_of(*node);
  if (!word) reject(key, "must be a text, a number, true or false");
  return word;
}

std::optional<std::vector<std::string>> TomlTable::texts(const std::string& key) {
  known_.push_back(key);
  const toml::node* node = node_->get(key);
  if (node == nullptr) return std::nullopt;
  const char* problem = "must be a list of texts, as [\"one\", \"two\"]";
  if (!node->is_array()) reject(key, problem);
  std::vector<std::string> values;
  for (const toml::node& item : *node->as_array()) {
    if (!item.is_string()) reject(key, problem);
    values.push_back(*item.value_exact<std::string>());
  }
  return values;
}

std::optional<std::vector<std::int64_t>> TomlTable::integers(const std::string& key) {
  known_.push_back(key);
  const toml::node* node = node_->get(key);
  if (node == nullptr) return std::nullopt;
  const char* problem = "must be a list of whole numbers, as [0, 1, 2]";
  if (!node->is_array()) reject(key, problem);
  std::vector<std::int64_t> values;
  for (const toml::node& item : *node->as_array()) {
    if (!item.is_integer()) reject(key, problem);
    values.push_back(*item.value_exact<std::int64_t>());
  }
  return values;
}

std::optional<TomlTable> TomlTable::table(const std::string& key) {
  known_.push_back(key);
  const toml::node* node = node_->get(key);
  if (node == nullptr) return std::nullopt;
  if (!node->is_table()) reject(key, "must be a table, as [" + full_name(key) + "]");
  return TomlTable(std::make_shared<const Node>(node_->inside(*node->as_table(), full_name(key))));
}

std::optional<std::vector<TomlTable>> TomlTable::tables(const std::string& key) {
  known_.push_back(key);
  const toml::node* node = node_->get(key);
  if (node == nullptr) return std::nullopt;
  const std::string problem = "must be a list of tables, each as [[" + full_name(key) + "]]";
  if (!node->is_array()) reject(key, problem);
  std::vector<TomlTable> values;
  for (const toml::node& item : *node->as_array()) {
    if (!item.is_table()) reject(key, problem);
    values.push_back(
        TomlTable(std::make_shared<const Node>(node_->inside(*item.as_table(), full_name(key)))));
  }
  return values;
}

void TomlTable::numbers(
    const std::function<void(const std::string&, double, TomlTable&, const std::string&)>& take) {
  std::vector<std::string> keys;
  for (const auto& [key, node] : *node_->table) {
    const std::string name(key.str());
    if (std::find(known_.begin(), known_.end(), name) == known_.end()) keys.push_back(name);
  }
  for (const std::string& key : keys) {
    if (node_->get(key)->is_table()) {
      table(key)->numbers([&](const std::string& name, double value, TomlTable& place,
                              const std::string& leaf) { take(key + "." + name, value, place, leaf); });
    } else {
      take(key, *number(key), *this, key);
    }
  }
}

void TomlTable::finish() const {
  for (const auto& [key, node] : *node_->table) {
    const std::string name(key.str());
    if (std::find(known_.begin(), known_.end(), name) != known_.end()) continue;
    throw std::invalid_argument(node_->place(key.source()) + ": unknown key " + full_name(name) + " = " +
                                shown(node) + did_you_mean(name, known_) +
                                "; known here are: " + listed(known_));
  }
}

}  // namespace schedule

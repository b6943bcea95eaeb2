#include "experiments/schedule/toml_reader.h"

#include <toml++/toml.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace schedule {
namespace {

constexpr std::size_t longest_value = 60;  // of a value in a message

std::string shown(const toml::node& node) {
  if (node.is_table()) return "{...}";
  if (node.is_array() && !node.as_array()->empty() && node.as_array()->get(0)->is_table()) return "[{...}]";
  std::ostringstream out;
  out << toml::node_view<const toml::node>(&node);
  std::string value = out.str();
  std::replace(value.begin(), value.end(), '\n', ' ');
  if (value.size() > longest_value) value = value.substr(0, longest_value) + "...";
  return value;
}

std::string listed(const std::vector<std::string>& words) {
  std::string list;
  for (const std::string& word : words) list += (list.empty() ? "" : ", ") + word;
  return list;
}

}  // namespace

struct TomlTable::Node {
  std::shared_ptr<const toml::table> root;  // keeps `table` alive
  const toml::table* table = nullptr;
  std::string file;
  std::string path;  // "teams.a"; empty at the root

  std::string place(const toml::source_region& source) const {
    return file + ":" + std::to_string(source.begin.line);
  }
};

TomlTable TomlTable::parse(const std::string& text, const std::string& file) {
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
  const toml::node* node = node_->table->get(key);
  return node != nullptr && node->is_string();
}

std::string TomlTable::place(const std::string& key) const {
  return node_->place(node_->table->get(key)->source());
}

void TomlTable::reject(const std::string& key, const std::string& problem) const {
  const toml::node* node = node_->table->get(key);
  throw std::invalid_argument(place(key) + ": " + full_name(key) + " = " + shown(*node) + ": " + problem);
}

void TomlTable::missing(const std::string& key, const std::string& hint) const {
  throw std::invalid_argument(node_->place(node_->table->source()) + ": " + full_name(key) + " is missing; " +
                              hint);
}

std::optional<std::string> TomlTable::text(const std::string& key) {
  known_.push_back(key);
  const toml::node* node = node_->table->get(key);
  if (node == nullptr) return std::nullopt;
  if (!node->is_string()) reject(key, "must be a text in quotes");
  return node->value_exact<std::string>();
}

std::optional<std::int64_t> TomlTable::integer(const std::string& key) {
  known_.push_back(key);
  const toml::node* node = node_->table->get(key);
  if (node == nullptr) return std::nullopt;
  if (!node->is_integer()) reject(key, "must be a whole number");
  return node->value_exact<std::int64_t>();
}

std::optional<bool> TomlTable::boolean(const std::string& key) {
  known_.push_back(key);
  const toml::node* node = node_->table->get(key);
  if (node == nullptr) return std::nullopt;
  if (!node->is_boolean()) reject(key, "must be true or false");
  return node->value_exact<bool>();
}

std::optional<double> TomlTable::number(const std::string& key) {
  known_.push_back(key);
  const toml::node* node = node_->table->get(key);
  if (node == nullptr) return std::nullopt;
  if (!node->is_number()) reject(key, "must be a number");
  return node->value<double>();
}

std::optional<std::vector<std::string>> TomlTable::texts(const std::string& key) {
  known_.push_back(key);
  const toml::node* node = node_->table->get(key);
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
  const toml::node* node = node_->table->get(key);
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
  const toml::node* node = node_->table->get(key);
  if (node == nullptr) return std::nullopt;
  if (!node->is_table()) reject(key, "must be a table, as [" + full_name(key) + "]");
  return TomlTable(
      std::make_shared<const Node>(Node{node_->root, node->as_table(), node_->file, full_name(key)}));
}

std::optional<std::vector<TomlTable>> TomlTable::tables(const std::string& key) {
  known_.push_back(key);
  const toml::node* node = node_->table->get(key);
  if (node == nullptr) return std::nullopt;
  const std::string problem = "must be a list of tables, each as [[" + full_name(key) + "]]";
  if (!node->is_array()) reject(key, problem);
  std::vector<TomlTable> values;
  for (const toml::node& item : *node->as_array()) {
    if (!item.is_table()) reject(key, problem);
    values.push_back(TomlTable(
        std::make_shared<const Node>(Node{node_->root, item.as_table(), node_->file, full_name(key)})));
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
    if (node_->table->get(key)->is_table()) {
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
                                shown(node) + "; known here are: " + listed(known_));
  }
}

}  // namespace schedule

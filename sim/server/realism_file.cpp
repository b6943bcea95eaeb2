#include "sim/server/realism_file.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <filesystem>
#include <stdexcept>
#include <string_view>

#include "sim/files/regular_file.h"

namespace server {
namespace {

constexpr const char* usual_preset = "measured";  // as in designs
constexpr std::size_t largest_file = 1 << 20;     // [bytes] as of designs

[[noreturn]] void reject(const std::string& file, const toml::node& node, const std::string& problem) {
  throw std::invalid_argument(fmt::format("{}:{}: {}", file, node.source().begin.line, problem));
}

/// Does what may throw, and says where in the file its reason stands.
template <class Action>
void at(const std::string& file, const toml::node& node, const Action& action) {
  try {
    action();
  } catch (const std::invalid_argument& error) {
    reject(file, node, error.what());
  }
}

void take_preset(const toml::node& node, const std::string& file, engine::Realism& realism) {
  const auto name = node.value_exact<std::string>();
  if (!name) reject(file, node, "the preset must be a text in quotes, as \"measured\"");
  at(file, node, [&] { realism = engine::realism(*name); });
}

/// Rounded: toml++'s own conversion gives nothing for a whole number that no double is.
double number_of(const toml::node& node) {
  if (node.is_integer()) return static_cast<double>(*node.value_exact<std::int64_t>());
  return *node.value_exact<double>();
}

/// @param prefix  of the keys in this table: "", "vision."
void take_numbers(const toml::table& table, const std::string& prefix, const std::string& file,
                  engine::Realism& realism) {
  for (const auto& [key, node] : table) {
    const std::string name = prefix + std::string(key.str());
    if (name == "preset") continue;
    if (node.is_table()) {
      take_numbers(*node.as_table(), name + ".", file, realism);
    } else if (!node.is_number()) {
      reject(file, node, fmt::format("realism {} must be a number", name));
    } else {
      at(file, node, [&] { engine::set(realism, name, number_of(node)); });
    }
  }
}

std::string text_of(const std::string& file) {
  try {
    return files::text_of(file, largest_file);
  } catch (const std::runtime_error& error) {
    throw std::invalid_argument(error.what());
  }
}

}  // namespace

engine::Realism parse_realism(const std::string& text, const std::string& file) {
  toml::table root;
  try {
    root = toml::parse(text, file);
  } catch (const toml::parse_error& error) {
    throw std::invalid_argument(
        fmt::format("{}:{}: not TOML: {}", file, error.source().begin.line, error.description()));
  }
  const toml::node* node = root.get("realism");
  if (node == nullptr) {
    throw std::invalid_argument(file + ":1: there is no table [realism] with a preset and numbers");
  }
  engine::Realism realism = engine::realism(usual_preset);
  if (node->is_string()) {  // realism = "harsh", as designs may say
    take_preset(*node, file, realism);
    return realism;
  }
  if (!node->is_table()) reject(file, *node, "realism must be a table, as [realism]");
  const toml::table& table = *node->as_table();
  if (const toml::node* preset = table.get("preset")) take_preset(*preset, file, realism);
  take_numbers(table, "", file, realism);
  return realism;
}

engine::Realism named_realism(const std::string& word) {
  for (const engine::Realism& preset : engine::realism_presets()) {
    if (preset.name == word) return preset;
  }
  std::error_code unreadable;  // then it is no directory
  if (std::filesystem::is_directory(word, unreadable)) {
    throw std::invalid_argument(
        fmt::format("--realism {}: is a directory; give a preset or a file that ends in .toml", word));
  }
  if (word.ends_with(".toml")) return parse_realism(text_of(word), word);
  if (word.find('/') != std::string::npos || std::filesystem::exists(word, unreadable)) {
    throw std::invalid_argument(fmt::format(
        "--realism {}: the name of a file must end in .toml, and it holds a table [realism]", word));
  }
  try {
    return engine::realism(word);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(std::string(error.what()) + ", or a file that ends in .toml");
  }
}

}  // namespace server

#include "teams/kit/settings_file.h"

#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <stdexcept>

#include "sim/files/regular_file.h"

namespace kit {
namespace {

constexpr std::size_t largest_file = 1 << 20;  // [bytes] ours: settings have some hundred

std::string text_of(const toml::node& node) {
  if (const auto* value = node.as_string()) return value->get();
  if (const auto* value = node.as_boolean()) return value->get() ? "true" : "false";
  if (const auto* value = node.as_integer()) return std::to_string(value->get());
  if (const auto* value = node.as_floating_point()) {
    std::array<char, 32> text;
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value->get()).ptr;
    return {text.data(), end};
  }
  return {};
}

}  // namespace

std::vector<Setting> read_settings(const std::string& path) {
  std::string text;
  try {
    text = files::text_of(path, largest_file);
  } catch (const std::runtime_error& error) {
    throw std::invalid_argument(std::string(error.what()) + "; give the path of a TOML file");
  }
  toml::table table;
  try {
    table = toml::parse(text, path);
  } catch (const toml::parse_error& error) {
    throw std::invalid_argument(path + ":" + std::to_string(error.source().begin.line) +
                                ": is no TOML: " + std::string(error.description()));
  }
  std::vector<Setting> settings;
  for (const auto& [key, node] : table) {
    Setting setting;
    setting.key = std::string(key.str());
    setting.line = static_cast<int>(node.source().begin.line);
    setting.value = text_of(node);
    if (!node.is_string() && setting.value.empty()) {
      throw std::invalid_argument(path + ":" + std::to_string(setting.line) + ": " + setting.key +
                                  " must be a number, true, false or a string; tables and lists have no "
                                  "meaning here");
    }
    settings.push_back(std::move(setting));
  }
  std::sort(settings.begin(), settings.end(),
            [](const Setting& a, const Setting& b) { return a.line < b.line; });
  return settings;
}

}  // namespace kit

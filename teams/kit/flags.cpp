#include "teams/kit/flags.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <stdexcept>

#include "teams/kit/settings_file.h"

namespace kit {
namespace {

std::string text_of(double value) {
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%g", value);
  return text.data();
}

std::string listed(const std::vector<std::string>& choices) {
  std::string text;
  for (const std::string& choice : choices) text += (text.empty() ? "" : "|") + choice;
  return text;
}

template <class T>
std::optional<T> number(const std::string& text) {
  T value{};
  const char* end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, value);
  if (result.ec != std::errc{} || result.ptr != end) return {};
  return value;
}

// The sentence's second half, what follows "shot-speed".
struct Setter {
  const std::string& text;

  template <class Target>
  std::optional<std::string> in_range(const Target& target, const char* kind) const {
    using T = std::remove_pointer_t<decltype(target.value)>;
    const auto value = number<T>(text);
    if (!value || !(*value >= target.low && *value <= target.high)) {
      return "must be " + std::string(kind) + " between " + text_of(target.low) + " and " +
             text_of(target.high) + " instead of '" + text + "'";
    }
    *target.value = *value;
    return {};
  }
};

}  // namespace

void Flags::add(std::string name, double& value, double low, double high, std::string help) {
  flags_.push_back({std::move(name), std::move(help), Number{&value, low, high}});
}
void Flags::add(std::string name, int& value, int low, int high, std::string help) {
  flags_.push_back({std::move(name), std::move(help), Integer{&value, low, high}});
}
void Flags::add(std::string name, bool& value, std::string help) {
  flags_.push_back({std::move(name), std::move(help), Switch{&value}});
}
void Flags::add(std::string name, std::string& value, std::vector<std::string> choices, std::string help) {
  flags_.push_back({std::move(name), std::move(help), Choice{&value, std::move(choices)}});
}

const Flags::Flag* Flags::find(const std::string& name) const {
  for (const Flag& flag : flags_) {
    if (flag.name == name) return &flag;
  }
  return nullptr;
}

std::string Flags::shown(const Flag& flag) {
  if (const auto* target = std::get_if<Number>(&flag.target)) {
    return text_of(target->low) + ".." + text_of(target->high) + " [" + text_of(*target->value) + "]";
  }
  if (const auto* target = std::get_if<Integer>(&flag.target)) {
    return std::to_string(target->low) + ".." + std::to_string(target->high) + " [" +
           std::to_string(*target->value) + "]";
  }
  if (const auto* target = std::get_if<Switch>(&flag.target)) {
    return std::string("on|off [") + (*target->value ? "on" : "off") + "]";
  }
  const auto& target = std::get<Choice>(flag.target);
  return listed(target.choices) + " [" + *target.value + "]";
}

std::optional<std::string> Flags::set(const std::string& name, const std::string& text) const {
  const Flag* flag = find(name);
  if (flag == nullptr) return "is no parameter of this team";
  const Setter setter{text};
  if (const auto* target = std::get_if<Number>(&flag->target)) return setter.in_range(*target, "a number");
  if (const auto* target = std::get_if<Integer>(&flag->target)) {
    return setter.in_range(*target, "a whole number");
  }
  if (const auto* target = std::get_if<Switch>(&flag->target)) {
    const bool on = text == "on" || text == "true";
    if (!on && text != "off" && text != "false") return "must be on or off instead of '" + text + "'";
    *target->value = on;
    return {};
  }
  const auto& target = std::get<Choice>(flag->target);
  if (std::find(target.choices.begin(), target.choices.end(), text) == target.choices.end()) {
    return "must be one of " + listed(target.choices) + " instead of '" + text + "'";
  }
  *target.value = text;
  return {};
}

std::string Flags::file_problem(const std::string& path) const {
  try {
    for (const Setting& setting : read_settings(path)) {
      if (const auto problem = set(setting.key, setting.value)) {
        return path + ":" + std::to_string(setting.line) + ": " + setting.key + " " + *problem;
      }
    }
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return {};
}

std::optional<int> Flags::parse(int argc, const char* const* argv, const std::string& program,
                                const std::string& description) const {
  const auto refuse = [&program](std::string sentence) {
    std::replace(sentence.begin(), sentence.end(), '\n', ' ');
    std::cerr << program << ": " << sentence << " (see --help)\n";
    return 2;
  };
  CLI::App app{description, program};
  std::string file;
  app.add_option("--config", file, "file with any of the parameters below, as in shot-speed = 6.5")
      ->type_name("FILE.toml");
  std::vector<std::string> texts(flags_.size());
  std::vector<CLI::Option*> options;
  for (std::size_t i = 0; i < flags_.size(); ++i) {
    options.push_back(
        app.add_option("--" + flags_[i].name, texts[i], flags_[i].help)->type_name(shown(flags_[i])));
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    std::cout << app.help();
    return 0;
  } catch (const CLI::ParseError& error) {
    return refuse(error.what());
  }
  if (!file.empty()) {
    if (std::string problem = file_problem(file); !problem.empty()) return refuse(std::move(problem));
  }
  for (std::size_t i = 0; i < flags_.size(); ++i) {
    if (options[i]->empty()) continue;
    if (const auto problem = set(flags_[i].name, texts[i])) {
      return refuse("--" + flags_[i].name + " " + *problem);
    }
  }
  return {};
}

}  // namespace kit

#include "teams/kit/flags.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <iostream>
#include <map>

namespace kit {

void Flags::add(std::string name, double& value, double low, double high, std::string help) {
  numbers_.push_back({std::move(name), &value, low, high, std::move(help)});
}
void Flags::add(std::string name, int& value, int low, int high, std::string help) {
  integers_.push_back({std::move(name), &value, low, high, std::move(help)});
}
void Flags::add(std::string name, bool& value, std::string help) {
  switches_.push_back({std::move(name), &value, std::move(help)});
}
void Flags::add(std::string name, std::string& value, std::vector<std::string> choices, std::string help) {
  choices_.push_back({std::move(name), &value, std::move(choices), std::move(help)});
}

std::optional<int> Flags::parse(int argc, const char* const* argv, const std::string& program,
                                const std::string& description) const {
  CLI::App app{description, program};
  app.option_defaults()->always_capture_default();
  for (const Number& flag : numbers_) {
    app.add_option("--" + flag.name, *flag.value, flag.help)->check(CLI::Range(flag.low, flag.high));
  }
  for (const Integer& flag : integers_) {
    app.add_option("--" + flag.name, *flag.value, flag.help)->check(CLI::Range(flag.low, flag.high));
  }
  std::map<std::string, std::string> switches;  // stable places for the texts; ordered, so the help is too
  for (const Switch& flag : switches_) {
    std::string& text = switches[flag.name];
    text = *flag.value ? "on" : "off";
    app.add_option("--" + flag.name, text, flag.help)->check(CLI::IsMember({"on", "off"}));
  }
  for (const Choice& flag : choices_) {
    app.add_option("--" + flag.name, *flag.value, flag.help)->check(CLI::IsMember(flag.choices));
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    std::cout << app.help();
    return 0;
  } catch (const CLI::ParseError& error) {
    std::string sentence = error.what();
    for (char& c : sentence) {
      if (c == '\n') c = ' ';
    }
    std::cerr << program << ": " << sentence << " (see --help)\n";
    return 2;
  }
  for (const Switch& flag : switches_) *flag.value = switches[flag.name] == "on";
  return {};
}

}  // namespace kit

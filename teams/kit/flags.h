#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace kit {

/// What a team lets its user set, each with a checked range: as a flag of the command line,
/// or as a key of the same name in a TOML file given with `--config`. The command line has the last
/// word; `--help` lists them.
class Flags {
 public:
  void add(std::string name, double& value, double low, double high, std::string help);
  void add(std::string name, int& value, int low, int high, std::string help);
  void add(std::string name, bool& value, std::string help);  ///< on|off; true and false in a file
  void add(std::string name, std::string& value, std::vector<std::string> choices, std::string help);

  /// Reads the command line, and the file it names, into the values.
  ///
  /// @return  an exit code when the program is to end: 0 after --help, 2 after a bad flag, file,
  ///          key or value, said in one sentence
  std::optional<int> parse(int argc, const char* const* argv, const std::string& program,
                           const std::string& description) const;

  /// Sets one value from its text.
  /// @return  what is wrong with it: "must be between 0 and 1 instead of 7"; nothing when it is fine
  std::optional<std::string> set(const std::string& name, const std::string& text) const;

  bool has(const std::string& name) const { return find(name) != nullptr; }

 private:
  struct Number {
    double* value;
    double low, high;
  };
  struct Integer {
    int* value;
    int low, high;
  };
  struct Switch {
    bool* value;
  };
  struct Choice {
    std::string* value;
    std::vector<std::string> choices;
  };
  struct Flag {
    std::string name;
    std::string help;
    std::variant<Number, Integer, Switch, Choice> target;
  };
  static std::string shown(const Flag& flag);  // its range and default, for the help
  const Flag* find(const std::string& name) const;
  std::string file_problem(const std::string& path) const;

  std::vector<Flag> flags_;
};

}  // namespace kit

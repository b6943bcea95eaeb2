#pragma once

#include <optional>
#include <string>
#include <vector>

namespace kit {

/// What a team lets its user set on the command line, each with a checked range; `--help` lists them.
class Flags {
 public:
  void add(std::string name, double& value, double low, double high, std::string help);
  void add(std::string name, int& value, int low, int high, std::string help);
  void add(std::string name, bool& value, std::string help);  ///< on|off
  void add(std::string name, std::string& value, std::vector<std::string> choices, std::string help);

  /// Reads the command line into the values.
  ///
  /// @return  an exit code when the program is to end: 0 after --help, 2 after a bad flag, said in one
  /// sentence
  std::optional<int> parse(int argc, const char* const* argv, const std::string& program,
                           const std::string& description) const;

 private:
  struct Number {
    std::string name;
    double* value;
    double low, high;
    std::string help;
  };
  struct Integer {
    std::string name;
    int* value;
    int low, high;
    std::string help;
  };
  struct Switch {
    std::string name;
    bool* value;
    std::string help;
  };
  struct Choice {
    std::string name;
    std::string* value;
    std::vector<std::string> choices;
    std::string help;
  };
  std::vector<Number> numbers_;
  std::vector<Integer> integers_;
  std::vector<Switch> switches_;
  std::vector<Choice> choices_;
};

}  // namespace kit

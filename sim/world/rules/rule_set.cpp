#include "sim/world/rules/rule_set.h"

#include <array>
#include <stdexcept>

#include "sim/world/rules/paper.h"
#include "sim/world/rules/ssl_2015.h"

namespace world {
namespace {

const std::array<RuleSet, 2>& all() {
  static const std::array<RuleSet, 2> rules = {ssl_2015(), paper()};
  return rules;
}

}  // namespace

const RuleSet& rule_set(std::string_view name) {
  std::string known;
  for (const RuleSet& rules : all()) {
    if (rules.name == name) return rules;
    known += (known.empty() ? "" : ", ") + rules.name;
  }
  throw std::invalid_argument("unknown rule set '" + std::string(name) + "'; known are: " + known);
}

std::vector<std::string_view> rule_set_names() {
  std::vector<std::string_view> names;
  for (const RuleSet& rules : all()) names.push_back(rules.name);
  return names;
}

}  // namespace world

#include "sim/world/rules/rule_set.h"

#include <algorithm>
#include <stdexcept>

#include "sim/world/rules/fields.h"
#include "sim/world/rules/paper.h"
#include "sim/world/rules/ssl_2015.h"

namespace world {
namespace {

std::vector<RuleSet> every() {
  std::vector<RuleSet> all = {ssl_2015(), paper()};
  for (const NamedField& other : other_fields()) {
    for (RuleSet rules : {ssl_2015(), paper()}) {
      rules.name += "-" + std::string(other.name);
      rules.field = other.field;
      all.push_back(std::move(rules));
    }
  }
  return all;
}

const std::vector<RuleSet>& all() {
  static const std::vector<RuleSet> rules = every();
  return rules;
}

}  // namespace

bool runs(const RuleSet& rules, std::string_view detector) {
  return std::ranges::find(rules.detectors, detector) != rules.detectors.end();
}

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

#pragma once

#include "sim/world/rules/rule_set.h"

namespace world {

/// The paper as printed wherever it can run.
RuleSet paper();

}  // namespace world

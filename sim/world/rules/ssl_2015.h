#pragma once

#include "sim/world/rules/rule_set.h"

namespace world {

/// The paper's game with the laws of 2015, contradictions resolved (reference
/// "requirements", 1.9). The default.
RuleSet ssl_2015();

}  // namespace world

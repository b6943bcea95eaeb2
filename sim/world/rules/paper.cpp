#include "sim/world/rules/paper.h"

#include "sim/world/rules/ssl_2015.h"

namespace world {

RuleSet paper() {
  RuleSet rules = ssl_2015();
  rules.name = "paper";
  rules.retake_keeps_call = false;                                 // Table 18, third row
  rules.direct_from_goal_line = false;                             // Algorithm 2 and Table 11
  rules.touch = {.accel = true, .line = true, .backtrack = true};  // 6.5.2; nothing of ours
  return rules;
}

}  // namespace world

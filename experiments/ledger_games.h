#pragma once

#include <string>
#include <vector>

#include "experiments/record/ledger.h"
#include "experiments/schedule/design.h"

namespace commands {

/// Takes attempts and audits of games that the design does not have, or has otherwise (seed, sides, colours),
/// out of what was readable: they are damaged, and get a sentence each.
void compare_with_design(const schedule::Design& design, record::LedgerCheck& rows);

}  // namespace commands

#pragma once

#include <span>

#include "autoref/automaton/row.h"

namespace automaton {

/// The paper's Tables 10 to 18 as resolved in reference "requirements", 1.7, in the order
/// in which they are tried.
///
/// The order says who goes first when several things happen in one tick: a touch before everything that asks
/// who touched the ball last (I-29), fouls before the goal they would spoil, a goal before the exit it would
/// be otherwise, the end of a half before the restart that would follow.
std::span<const Row> transitions();

}  // namespace automaton

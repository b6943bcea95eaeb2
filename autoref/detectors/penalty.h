#pragma once

#include <optional>

#include "sim/world/field.h"
#include "sim/world/game_state.h"
#include "sim/world/tracked_frame.h"

namespace detectors {

/// One robot of each team that is where a penalty kick does not allow it to be, if there is any.
struct PenaltyOffenders {
  std::optional<world::RobotId> attacker;
  std::optional<world::RobotId> defender;
};

/// Who stands wrongly for the penalty kick of `state.kick_team`.
///
/// Rule    laws of 2015, Law 14 (R-R15-15): the defending keeper on its goal line between the posts, the
///         kicker (the robot of its team nearest to the mark) anywhere, all others in the field and behind a
///         line parallel to the goal line, `line` [m] behind the mark. A keeper that is not on the field
///         cannot offend. Hulls are measured, with 30 mm of tolerance (ours: the filter's error, and a
///         keeper's first step in the two or three frames until a kick is noticed).
PenaltyOffenders penalty_offenders(const world::Field& field, double line, const world::TrackedFrame& frame,
                                   const world::GameState& state);

}  // namespace detectors

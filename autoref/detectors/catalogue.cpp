#include "autoref/detectors/catalogue.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "autoref/detectors/aimless_kick.h"
#include "autoref/detectors/attacker_in_area.h"
#include "autoref/detectors/ball_left_field.h"
#include "autoref/detectors/ball_touched.h"
#include "autoref/detectors/chipped_goal.h"
#include "autoref/detectors/collision.h"
#include "autoref/detectors/defender_in_area.h"
#include "autoref/detectors/double_touch.h"
#include "autoref/detectors/dribbled_too_far.h"
#include "autoref/detectors/goal.h"
#include "autoref/detectors/interfered_placement.h"
#include "autoref/detectors/keeper_contact.h"
#include "autoref/detectors/keeper_held_ball.h"
#include "autoref/detectors/kick_taken.h"
#include "autoref/detectors/kicked_too_fast.h"
#include "autoref/detectors/no_progress.h"
#include "autoref/detectors/robot_left_field.h"
#include "autoref/detectors/robots_settled.h"
#include "autoref/detectors/too_fast_in_stop.h"
#include "autoref/detectors/too_many_robots.h"
#include "autoref/detectors/too_near_in_stop.h"

namespace detectors {
namespace {

using enum world::Location;

template <class Kind>
std::unique_ptr<Detector> make(const world::RuleSet& rules) {
  return std::make_unique<Kind>(rules);
}

// Two of the paper's ten events (6.4) need no detector: a kick that takes too long and the end of a half are
// guards on the automaton's variables. A robot near the area or the ball at a kick is part of "kick taken".
constexpr std::array<Entry, 21> all = {{
    // event                  applies in   made by
    {"ball touched", {GameOn}, make<BallTouched>},
    {"double touch", {GameOn}, make<DoubleTouch>},
    {"chip goal", {GameOn}, make<ChippedGoal>},
    {"ball too fast", {GameOn}, make<KickedTooFast>},
    {"dribbled too far", {GameOn}, make<DribbledTooFar>},
    {"collision", {GameOn}, make<Collision>},
    {"touched the goalie", {GameOn}, make<KeeperContact>},
    {"defender in own area", {GameOn}, make<DefenderInArea>},
    {"attacker in area", {GameOn}, make<AttackerInArea>},
    {"goalie holds the ball", {GameOn}, make<KeeperHeldBall>},
    {"icing", {GameOn}, make<AimlessKick>},
    {"goal", {GameOn}, make<Goal>},
    {"ball left field", {GameOn}, make<BallLeftField>},
    {"no progress", {GameOn}, make<NoProgress>},
    {"too many robots", {GameOn}, make<TooManyRobots>},
    {"robot left field", {GameOn}, make<RobotLeftField>},
    {"kick taken", {Setup}, make<KickTaken>},
    {"robots settled", {GameOff}, make<RobotsSettled>},
    {"too fast in stop", {GameOff}, make<TooFastInStop>},
    {"too near in stop", {GameOff}, make<TooNearInStop>},
    {"interfered placement", {GameOff}, make<InterferedPlacement>},
}};

}  // namespace

std::span<const Entry> catalogue() { return all; }

Detectors::Detectors(const world::RuleSet& rules) {
  for (const std::string_view name : rules.detectors) {
    if (std::ranges::find(all, name, &Entry::name) == all.end()) {
      throw std::invalid_argument("rule set " + rules.name + ": no detector is called '" + std::string(name) +
                                  "'; autoref/detectors/catalogue.cpp lists all");
    }
  }
  for (const Entry& entry : all) {
    if (world::runs(rules, entry.name)) running_.push_back({entry.where, entry.make(rules)});
  }
}

void Detectors::enter(world::Location location) {
  for (const Running& running : running_) {
    if (running.where.contains(location)) running.detector->reset();
  }
}

std::span<const world::GameEvent> Detectors::update(const world::TrackedFrame& frame,
                                                    const world::GameState& state) {
  events_.clear();
  for (const Running& running : running_) {
    if (!running.where.contains(state.location)) continue;
    for (world::GameEvent& event : running.detector->update(frame, state)) {
      events_.push_back(std::move(event));
    }
  }
  return events_;
}

}  // namespace detectors

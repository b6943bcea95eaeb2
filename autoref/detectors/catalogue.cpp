#include "autoref/detectors/catalogue.h"

#include <array>

#include "autoref/detectors/ball_left_field.h"
#include "autoref/detectors/ball_touched.h"
#include "autoref/detectors/double_touch.h"
#include "autoref/detectors/dribbled_too_far.h"
#include "autoref/detectors/goal.h"
#include "autoref/detectors/kick_taken.h"
#include "autoref/detectors/kicked_too_fast.h"
#include "autoref/detectors/no_progress.h"
#include "autoref/detectors/robots_settled.h"

namespace detectors {
namespace {

using enum world::Location;

template <class Kind>
std::unique_ptr<Detector> make(const world::RuleSet& rules) {
  return std::make_unique<Kind>(rules);
}

// Two of the paper's ten events (6.4) need no detector: a kick that takes too long and the end of a half are
// guards on the automaton's variables.
constexpr std::array<Entry, 9> all = {{
    // event               applies in   made by
    {"ball touched", {GameOn}, make<BallTouched>},
    {"double touch", {GameOn}, make<DoubleTouch>},
    {"ball too fast", {GameOn}, make<KickedTooFast>},
    {"dribbled too far", {GameOn}, make<DribbledTooFar>},
    {"goal", {GameOn}, make<Goal>},
    {"ball left field", {GameOn}, make<BallLeftField>},
    {"no progress", {GameOn}, make<NoProgress>},
    {"kick taken", {Setup}, make<KickTaken>},
    {"robots settled", {GameOff}, make<RobotsSettled>},
}};

}  // namespace

std::span<const Entry> catalogue() { return all; }

Detectors::Detectors(const world::RuleSet& rules) {
  for (const Entry& entry : catalogue()) detectors_.push_back(entry.make(rules));
}

void Detectors::enter(world::Location location) {
  for (std::size_t i = 0; i < detectors_.size(); ++i) {
    if (all[i].where.contains(location)) detectors_[i]->reset();
  }
}

std::span<const world::GameEvent> Detectors::update(const world::TrackedFrame& frame,
                                                    const world::GameState& state) {
  events_.clear();
  for (std::size_t i = 0; i < detectors_.size(); ++i) {
    if (!all[i].where.contains(state.location)) continue;
    for (world::GameEvent& event : detectors_[i]->update(frame, state)) events_.push_back(std::move(event));
  }
  return events_;
}

}  // namespace detectors

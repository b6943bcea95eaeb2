#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "autoref/detectors/catalogue.h"
#include "autoref/touch/touch_detector.h"
#include "autoref/tracker/tracker.h"
#include "sim/world/detection.h"
#include "sim/world/referee_message.h"
#include "sim/world/rules/rule_set.h"

namespace autoref {

/// Something a detector saw while another referee decided.
struct Sighting {
  world::Time time;  ///< of the frame with which it became certain
  world::GameEvent event;
};

/// Tracker, touch and detectors behind a foreign referee: the state follows its messages, nothing is decided.
///
/// READY, DIRECT and INDIRECT mean SETUP until a kick is seen; a message that was older
/// than the time for a kick when the log began means that the ball has been in play.
/// Modern commands are read as wire::decode does.
class Watcher {
 public:
  Watcher(const world::RuleSet& rules, const world::Geometry& geometry);

  void follow(const world::RefereeMessage& message);
  /// The events of one tick; of touches only the first of each toucher. Valid until the next call.
  std::span<const Sighting> update(std::span<const world::Detection> detections);

  const world::TrackedFrame& frame() const { return frame_; }
  const world::GameState& state() const { return state_; }

 private:
  void enter(world::Location location);
  void remember(const world::GameEvent& event);
  bool is_news(const world::GameEvent& event) const;

  world::RuleSet rules_;
  tracker::Tracker tracker_;
  touch::TouchDetector touches_;
  detectors::Detectors detectors_;
  world::TrackedFrame frame_;
  world::GameState state_;
  std::optional<world::Time> last_frame_;
  std::optional<world::RefereeMessage> followed_;  // the last one
  std::vector<Sighting> sightings_;
};

}  // namespace autoref

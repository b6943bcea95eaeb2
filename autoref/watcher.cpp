#include "autoref/watcher.h"

#include <algorithm>

namespace autoref {

using world::CommandKind;
using world::Location;

namespace {

world::RuleSet with_field(world::RuleSet rules, const world::Field& field) {
  rules.field = field;
  return rules;
}

constexpr world::Duration one_day = std::chrono::hours{24};

Location location_of(CommandKind command) {
  switch (command) {
    case CommandKind::Halt:
    case CommandKind::Timeout:
      return Location::Break;
    case CommandKind::Start:
      return Location::GameOn;
    case CommandKind::Ready:
    case CommandKind::Direct:
    case CommandKind::Indirect:
      return Location::Setup;
    default:
      return Location::GameOff;
  }
}

}  // namespace

Watcher::Watcher(const world::RuleSet& rules, const world::Geometry& geometry)
    : rules_(with_field(rules, geometry.field)),
      tracker_(geometry, {.ball_in_space = rules.chip_model}),
      touches_(geometry, rules_.touch),
      detectors_(rules_) {}

void Watcher::enter(Location location) {
  state_.location = location;
  state_.location_time = state_.time;
  detectors_.enter(location);
}

void Watcher::follow(const world::RefereeMessage& message) {
  state_.stage = message.stage;
  state_.blue_on_positive_half = message.blue_on_positive_half;
  for (const world::Team team : world::both_teams) {
    state_.score[team] = message.teams[team].score;
    state_.keeper[team] = message.teams[team].keeper;
  }
  const bool first = !followed_;
  const bool news = first || followed_->command_counter != message.command_counter ||
                    !(followed_->command == message.command);
  followed_ = message;
  if (!news) return;

  const CommandKind before = state_.command.kind;
  state_.command = message.command;
  // The clocks may differ. What is older than a day is as good as a day old: the difference must fit.
  const world::Duration age =
      std::clamp<world::Duration>(message.time - message.command_time, -one_day, one_day);
  state_.command_time = state_.time - age;
  if (world::has_team(message.command.kind)) state_.kick_team = message.command.team;
  state_.reset_position = message.designated_position;
  state_.kicker.reset();
  state_.is_kickoff = message.command.kind == CommandKind::Kickoff ||
                      (message.command.kind == CommandKind::Ready && before == CommandKind::Kickoff);
  Location location = location_of(message.command.kind);
  if (location == Location::Setup) {
    const bool long_ago = first && age > rules_.kick_time;
    if (long_ago) location = Location::GameOn;
    state_.kick_position.reset();
    if (frame_.ball) state_.kick_position = frame_.ball->position.head<2>();
  }
  enter(location);
}

std::span<const Sighting> Watcher::update(std::span<const world::Detection> detections) {
  sightings_.clear();
  const world::TrackedFrame* tracked = tracker_.update(detections);
  if (!tracked) return {};
  frame_ = *tracked;
  if (last_frame_ && frame_.time <= *last_frame_) {
    touches_.reset();
    state_.location_time = frame_.time;
    detectors_.enter(state_.location);
  }
  last_frame_ = frame_.time;
  frame_.touches.clear();
  touches_.update(frame_, detections, frame_.touches);

  state_.time = frame_.time;
  if (state_.location == Location::Setup && !state_.kick_position && frame_.ball) {
    state_.kick_position = frame_.ball->position.head<2>();
  }
  for (const world::GameEvent& event : detectors_.update(frame_, state_)) {
    if (is_news(event)) sightings_.push_back({frame_.time, event});
    remember(event);
  }
  return sightings_;
}

bool Watcher::is_news(const world::GameEvent& event) const {
  const auto* touched = std::get_if<world::BallTouched>(&event.what);
  return !touched || !state_.last_touch || state_.last_touch->robot != touched->touch.robot;
}

// What T13 and T14 do in the automaton: who touched the ball last.
void Watcher::remember(const world::GameEvent& event) {
  if (const auto* touched = std::get_if<world::BallTouched>(&event.what)) {
    if (state_.kicker != touched->touch.robot) state_.kicker.reset();
    state_.touch_team = touched->touch.robot.team;
    state_.last_touch = touched->touch;
  } else if (const auto* kick = std::get_if<world::KickTaken>(&event.what)) {
    state_.kicker = kick->by;
    state_.touch_team = kick->by.team;
    state_.last_touch = world::Touch{kick->by, event.time, kick->location, 1.0};
    enter(Location::GameOn);
  }
}

}  // namespace autoref

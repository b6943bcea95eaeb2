#include "experiments/judge/shadow.h"

#include <algorithm>
#include <utility>

namespace judge {

using world::Location;

namespace {

constexpr std::array locations = {Location::GameOn, Location::Setup, Location::GameOff};

world::RuleSet on(const world::Field& field, world::RuleSet rules) {
  rules.field = field;
  return rules;
}

}  // namespace

Shadow::Shadow(std::string name, const world::Geometry& geometry, world::RuleSet rules)
    : name_(std::move(name)), rules_(on(geometry.field, std::move(rules))), eyes_(geometry, rules_) {
  for (Part& part : parts_) part.detectors.emplace(rules_);
}

bool Shadow::see(std::span<const world::Detection> images, const Timeline& timeline, bool by_hand) {
  first_fresh_ = calls_.size();
  if (!eyes_.see(images)) return false;
  see(eyes_.frame(), timeline.at(eyes_.frame().time), by_hand);
  return true;
}

void Shadow::follow(Part& part, Location location, const world::GameState& state) {
  if (state.location == location) {
    const bool anew = !part.running || part.left || part.state.location_time != state.location_time;
    part.left.reset();
    part.state = state;
    if (!anew) return;
    part.running = true;
    part.detectors->enter(location);
    if (location != Location::GameOn) return;
    last_touch_.reset();
    // The referee knows who took the kick, whatever was seen of the touch.
    if (state.kicker) {
      last_touch_.emplace();
      last_touch_->robot = *state.kicker;
      last_touch_->time = state.location_time;
      last_touch_->position = state.kick_position.value_or(world::Vector2d::Zero());
    }
    if (!joined_) last_touch_ = state.last_touch;
  } else if (part.running && !part.left) {
    part.left = state.location_time;
  }
}

void Shadow::see(const world::TrackedFrame& frame, const world::GameState& state, bool by_hand) {
  first_fresh_ = calls_.size();
  last_frame_ = frame.time;
  for (std::size_t n = 0; n < parts_.size(); ++n) {
    Part& part = parts_[n];
    follow(part, locations[n], state);
    if (!part.running) continue;
    if (part.left && (frame.time > *part.left + linger || by_hand)) {
      part.running = false;
      continue;
    }
    if (locations[n] == Location::GameOn) {
      part.state.last_touch = last_touch_;
      part.state.touch_team = last_touch_ ? std::optional(last_touch_->robot.team) : part.state.touch_team;
    }
    const auto events = part.detectors->update(frame, part.state);
    const bool chipped = std::ranges::any_of(events, [](const world::GameEvent& event) {
      return std::holds_alternative<world::ChippedGoal>(event.what);
    });
    // Touches come before what they decide (requirements, I-29).
    for (const world::GameEvent& event : events) {
      if (const auto* touched = std::get_if<world::BallTouched>(&event.what)) last_touch_ = touched->touch;
    }
    for (const world::GameEvent& event : events) {
      take(event, frame, part, chipped);
    }
  }
  joined_ = true;
}

void Shadow::take(const world::GameEvent& event, const world::TrackedFrame& frame, const Part& part,
                  bool chipped) {
  Call call;
  call.time = event.time;
  call.reported = frame.time;
  call.late = part.left && event.time > *part.left;
  const auto add = [&](Event what, std::optional<world::RobotId> by, const world::Vector2d& place) {
    call.event = what;
    call.by = by;
    call.place = place;
    calls_.push_back(call);
  };
  const auto team_touch = [&](const std::optional<world::Touch>& touch) {
    call.last = last_touch_ ? last_touch_ : touch;
    if (!call.last && part.state.touch_team) {
      call.last.emplace();
      call.last->robot = {*part.state.touch_team, 0};
      call.last->probability = 0.5;
    }
  };
  using namespace world;
  const auto visit = [&](const auto& what) {
    using What = std::decay_t<decltype(what)>;
    if constexpr (std::is_same_v<What, BallLeftFieldTouchLine> ||
                  std::is_same_v<What, BallLeftFieldGoalLine>) {
      team_touch(what.last_touch);
      add(Event::Exit, call.last ? std::optional(call.last->robot) : std::nullopt, what.location);
    } else if constexpr (std::is_same_v<What, PossibleGoal>) {
      team_touch(what.last_touch);
      if (!chipped) add(Event::Goal, std::nullopt, what.location);
    } else if constexpr (std::is_same_v<What, world::ChippedGoal>) {
      add(Event::ChippedGoal, what.by, what.location);
    } else if constexpr (std::is_same_v<What, world::AimlessKick>) {
      add(Event::AimlessKick, what.by, what.location);
    } else if constexpr (std::is_same_v<What, BotKickedBallTooFast>) {
      add(Event::BallTooFast, what.by, what.location);
    } else if constexpr (std::is_same_v<What, BotDribbledBallTooFar>) {
      add(Event::DribbledTooFar, what.by, what.end);
    } else if constexpr (std::is_same_v<What, AttackerDoubleTouchedBall>) {
      add(Event::DoubleTouch, what.by, what.location);
    } else if constexpr (std::is_same_v<What, BotCrashUnique>) {
      add(Event::Collision, what.by, what.location);
    } else if constexpr (std::is_same_v<What, BotCrashDrawn>) {
      add(Event::Collision, std::nullopt, what.location);
    } else if constexpr (std::is_same_v<What, AttackerTouchedKeeper>) {
      add(Event::KeeperTouched, what.by, what.location);
    } else if constexpr (std::is_same_v<What, DefenderInDefenseArea>) {
      add(Event::DefenderInArea, what.by, what.location);
    } else if constexpr (std::is_same_v<What, AttackerTouchedBallInDefenseArea>) {
      add(Event::AttackerInArea, what.by, what.location);
    } else if constexpr (std::is_same_v<What, world::KeeperHeldBall>) {
      add(Event::KeeperHeldBall, what.by, what.location);
    } else if constexpr (std::is_same_v<What, NoProgressInGame>) {
      add(Event::NoProgress, std::nullopt, what.location);
    } else if constexpr (std::is_same_v<What, BotTooFastInStop>) {
      add(Event::TooFastInStop, what.by, what.location);
    } else if constexpr (std::is_same_v<What, BotTooNearInStop>) {
      add(Event::TooNearInStop, what.by, what.location);
    } else if constexpr (std::is_same_v<What, BotInterferedPlacement>) {
      add(Event::InterferedPlacement, what.by, what.location);
    } else if constexpr (std::is_same_v<What, BotLeftField>) {
      add(Event::RobotLeftField, what.by, what.location);
    } else if constexpr (std::is_same_v<What, world::TooManyRobots>) {
      add(Event::TooManyRobots, RobotId{what.team, 0}, Vector2d::Zero());
    } else if constexpr (std::is_same_v<What, world::KickTaken>) {
      add(Event::KickTaken, what.by, what.location);
      if (what.opponent_near_ball) add(Event::OpponentNearBall, what.opponent_near_ball, what.location);
      if (what.attacker_near_area) add(Event::AttackerNearArea, what.attacker_near_area, what.location);
      if (what.wrong_half) add(Event::WrongHalf, what.wrong_half, what.location);
    } else if constexpr (std::is_same_v<What, world::RobotsSettled>) {
      add(Event::RobotsSettled, std::nullopt, Vector2d::Zero());
    }
  };
  std::visit(visit, event.what);
}

}  // namespace judge

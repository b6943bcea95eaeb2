#include "autoref/detectors/area_touches.h"

#include <algorithm>
#include <chrono>

#include "autoref/detectors/ball.h"

namespace detectors {
namespace {

constexpr int frames_needed = 4;
constexpr double alone = 0.03;                 // [m] any opponent's hull from the ball
constexpr double alone_of_team_mates = 0.012;  // [m] the goalie stands near
constexpr world::Duration hidden_for = std::chrono::milliseconds{600};

}  // namespace

std::optional<world::Touch> AreaTouches::carried(const world::TrackedFrame& frame) {
  const world::TrackedRobot* carrier = nullptr;
  if (frame.ball && frame.ball->unseen < hidden_for) {
    const world::Vector2d ball = on_ground(*frame.ball);
    const auto far_from_area = [&](world::Side side) {
      return world::distance_to_defense_area(field_, side, ball) > 2 * field_.robot_radius;
    };
    if (!far_from_area(world::Side::Negative) || !far_from_area(world::Side::Positive)) {
      int carriers = 0;
      for (const world::TrackedRobot& robot : frame.robots) {
        if (!carries(field_, robot, *frame.ball)) continue;
        carrier = &robot;
        ++carriers;
      }
      const auto may_have_it = [&](const world::TrackedRobot& other) {
        const double enough = other.id.team == carrier->id.team ? alone_of_team_mates : alone;
        return other.id != carrier->id && gap_to_ball(field_, other, ball) < enough;
      };
      if (carriers != 1 || std::ranges::any_of(frame.robots, may_have_it)) carrier = nullptr;
    }
  }
  if (!carrier) {
    carried_ = 0;
    return std::nullopt;
  }
  carried_ = carrier->id == carrier_ ? carried_ + 1 : 1;
  carrier_ = carrier->id;
  if (carried_ < frames_needed) return std::nullopt;
  return world::Touch{carrier->id, frame.time, on_ground(*frame.ball)};
}

const std::vector<AreaTouches::One>& AreaTouches::update(const world::TrackedFrame& frame,
                                                         const world::GameState& state) {
  past_.add(frame);
  found_.clear();
  const auto add = [&](const world::Touch& touch) {
    if (touch.probability < sure_ || !in_play(field_, state, touch)) return;
    if (const auto place = past_.position(touch.robot, touch.time)) found_.push_back({touch, *place});
  };
  for (const world::Touch& touch : frame.touches) add(touch);
  if (const auto touch = carried(frame)) add(*touch);
  return found_;
}

}  // namespace detectors

#include "autoref/detectors/kick_taken.h"

#include <algorithm>

#include "autoref/detectors/ball.h"

namespace detectors {
namespace {

constexpr double kick_speed = 0.4;           // [m/s]
constexpr double least_travel = 0.02;        // [m] for a kick known by its speed: twice a camera's offset
constexpr double going_on = 0.003;           // [m] farther in the next frame, or it was a hiccup
constexpr double opponent_tolerance = 0.02;  // [m]
constexpr double same_place = 0.1;           // [m] twice the placement's tolerance

}  // namespace

std::optional<world::Time> KickTaken::when_taken(const world::TrackedFrame& frame,
                                                 const world::GameState& state) {
  const double distance = (on_ground(*frame.ball) - *state.kick_position).norm();
  const world::GuardSample moved{frame.time, distance - travel_};
  if (!moved_ && state.location_time < frame.time) {  // the ball lay there when the kick was signalled
    moved_ = world::GuardSample{state.location_time, -travel_};
  }
  std::optional<world::Time> taken;
  if (moved_) taken = rising_zero(*moved_, moved);

  const bool fast = frame.ball->velocity.head<2>().norm() >= kick_speed;
  if (!fast) {
    sped_up_.reset();
  } else if (!sped_up_) {
    sped_up_ = SpedUp{moved_ ? moved_->time : frame.time, distance};
  } else if (distance > least_travel && distance > sped_up_->distance + going_on) {
    taken = taken ? std::min(*taken, sped_up_->time) : sped_up_->time;
  }
  moved_ = moved;
  return taken;
}

Events KickTaken::update(const world::TrackedFrame& frame, const world::GameState& state) {
  if (reported_ || !observed_ball(frame) || !state.kick_position) return {};
  const auto taken = when_taken(frame, state);
  if (!taken) return {};
  reported_ = true;

  const world::Vector2d place = *state.kick_position;
  world::KickTaken kick;
  kick.by = {state.kick_team, 0};
  kick.location = place;
  if (const auto* kicker = nearest_robot(frame, place, state.kick_team)) kick.by = kicker->id;

  const world::Side attacked = world::other(world::defended_side(state, state.kick_team));
  for (const world::TrackedRobot& robot : frame.robots) {
    if (robot.id.team != state.kick_team) {
      const bool near = hull_distance(field_, robot, place) < opponent_distance_ - opponent_tolerance;
      if (near && !kick.opponent_near_ball) kick.opponent_near_ball = robot.id;
    } else if (robot.id != kick.by && !kick.attacker_near_area) {
      const double distance =
          world::distance_to_defense_area(field_, attacked, robot.position) - field_.robot_radius;
      if (distance < area_distance_) kick.attacker_near_area = robot.id;
    }
  }
  if (state.is_kickoff) kick.wrong_half = robot_in_wrong_half(frame, state);
  if (kick.opponent_near_ball && !state.is_kickoff) {
    kick.again = spoilt_ && spoilt_->team == state.kick_team && (spoilt_->place - place).norm() < same_place;
    spoilt_ = Attempt{state.kick_team, place};
  } else {
    spoilt_.reset();
  }
  return {{*taken, kick}};
}

}  // namespace detectors

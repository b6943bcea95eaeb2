#include "autoref/detectors/keeper_contact.h"

namespace detectors {
namespace {

constexpr int frames_needed = 2;
constexpr double touching = 0.001;  // [m] between hulls: the filter's error
constexpr double apart = 0.02;      // [m] between hulls

}  // namespace

Events KeeperContact::update(const world::TrackedFrame& frame, const world::GameState& state) {
  Events events;
  for (const world::Team defending : world::both_teams) {
    const world::RobotId id{defending, static_cast<std::uint8_t>(state.keeper[defending])};
    const world::TrackedRobot* keeper = find_robot(frame, id);
    if (!keeper || !keeper->observed) continue;
    const world::Side side = world::defended_side(state, defending);
    for (const world::TrackedRobot& robot : frame.robots) {
      if (robot.id.team == defending || !robot.observed || robot.id.number > world::max_robot_number)
        continue;
      int& frames = frames_[robot.id.team][robot.id.number];
      const double gap = (robot.position - keeper->position).norm() - 2 * field_.robot_radius;
      if (gap > apart) frames = 0;
      const world::Vector2d place = (robot.position + keeper->position) / 2;
      if (gap > touching || world::distance_to_defense_area(field_, side, place) > -margin_) continue;
      if (++frames == frames_needed) {
        events.push_back({frame.time, world::AttackerTouchedKeeper{robot.id, id, place}});
      }
    }
  }
  return events;
}

}  // namespace detectors

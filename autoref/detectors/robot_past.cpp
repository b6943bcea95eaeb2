#include "autoref/detectors/robot_past.h"

#include <algorithm>

namespace detectors {
namespace {

std::optional<world::Vector2d> find(const std::vector<std::pair<world::RobotId, world::Vector2d>>& robots,
                                    world::RobotId id) {
  for (const auto& [robot, position] : robots) {
    if (robot == id) return position;
  }
  return std::nullopt;
}

}  // namespace

void RobotPast::add(const world::TrackedFrame& frame) {
  Sample& sample = samples_[next_];
  sample.time = frame.time;
  sample.robots.clear();
  for (const world::TrackedRobot& robot : frame.robots) sample.robots.emplace_back(robot.id, robot.position);
  next_ = (next_ + 1) % samples_.size();
  count_ = std::min(count_ + 1, samples_.size());
}

std::optional<world::Vector2d> RobotPast::position(world::RobotId robot, world::Time time) const {
  for (std::size_t back = 0; back < count_; ++back) {
    const Sample& before = newest(back);
    if (before.time > time) continue;
    const auto from = find(before.robots, robot);
    if (back == 0 || !from) return from;
    const Sample& after = newest(back - 1);
    const auto to = find(after.robots, robot);
    if (!to) return from;
    const double share = world::seconds(time - before.time) / world::seconds(after.time - before.time);
    return *from + (*to - *from) * share;
  }
  return std::nullopt;
}

}  // namespace detectors

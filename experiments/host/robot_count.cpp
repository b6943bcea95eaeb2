#include "experiments/host/robot_count.h"

#include <algorithm>
#include <boost/container/static_vector.hpp>
#include <numbers>
#include <optional>

namespace host {
namespace {

using Numbers = boost::container::static_vector<std::uint8_t, world::max_robot_number + 1>;

Numbers on_field(const truth::Frame& truth, world::Team team) {
  Numbers numbers;
  for (const truth::Robot& robot : truth.robots) {
    if (robot.id.team == team) numbers.push_back(robot.id.number);
  }
  return numbers;
}

std::optional<std::uint8_t> who_leaves(const Numbers& numbers, int keeper,
                                       std::optional<std::uint8_t> preferred) {
  if (preferred && std::find(numbers.begin(), numbers.end(), *preferred) != numbers.end()) return preferred;
  for (auto number = numbers.rbegin(); number != numbers.rend(); ++number) {
    if (*number != keeper) return *number;
  }
  return std::nullopt;
}

constexpr double spacing = 0.3;  // [m] between places: a hull and a half; ours
constexpr double room = 0.25;    // [m] from any robot's centre: a hull and a gap; ours

// A place beside the halfway line, 0.3 m outside the touch line (hull wholly outside, inside the run-off of
// 0.7 m), in the own half, each next one further from the line; yellow comes in at -y, blue at +y.
std::optional<world::Vector2d> entrance(world::Team team, const world::GameState& state,
                                        const engine::Engine& engine) {
  const world::Field& field = engine.model().geometry.field;
  const double x_sign = world::sign(world::defended_side(state, team));
  const double y = (field.half_width() + 0.3) * (team == world::Team::Blue ? 1 : -1);
  for (int place = 0; place <= world::max_robot_number; ++place) {
    const world::Vector2d spot{x_sign * spacing * (place + 0.5), y};
    const auto& robots = engine.truth().robots;
    const bool is_free = std::none_of(robots.begin(), robots.end(), [&](const truth::Robot& robot) {
      return (robot.position - spot).norm() < room;
    });
    if (is_free) return spot;
  }
  return std::nullopt;
}

}  // namespace

void RobotCount::update(const world::RefereeMessage& message, const world::GameState& state,
                        engine::Engine& engine) {
  if (state.location != world::Location::GameOff) return;
  for (const world::Team team : world::both_teams) {
    const auto numbers = on_field(engine.truth(), team);
    const int allowed = message.teams[team].max_robots;
    const int present = static_cast<int>(numbers.size());
    if (present > allowed) {
      const auto number = who_leaves(numbers, message.teams[team].keeper, preferred_[team]);
      if (!number) continue;
      engine.remove_robot({team, *number});
      outside_[team].push_back(*number);
      preferred_[team].reset();
    } else if (present < allowed && !outside_[team].empty()) {
      const auto spot = entrance(team, state, engine);
      if (!spot) continue;
      const double facing_in = team == world::Team::Blue ? -std::numbers::pi / 2 : std::numbers::pi / 2;
      engine.put_robot({team, outside_[team].back()}, *spot, facing_in);
      outside_[team].pop_back();
    }
  }
}

}  // namespace host

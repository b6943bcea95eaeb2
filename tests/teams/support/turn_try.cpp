#include "tests/teams/support/turn_try.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "teams/skills/steer.h"
#include "tests/teams/support/arena.h"

namespace support {
namespace {

constexpr double hold_first = 0.5;  // [s] the tracker and the bar settle

class Turner final : public kit::Team {
 public:
  Turner(const skills::TurnCircle& circle, double angle) : circle_(circle), angle_(angle) {}
  void play(const kit::View& view, world::TeamCommands& out) override {
    if (view.own.empty()) return;
    const kit::Robot& robot = view.own.front();
    if (view.time < hold_first) start_ = robot.orientation;
    skills::Order order =
        skills::turn_with_ball(view, robot, start_ + (view.time < hold_first ? 0 : angle_), circle_);
    if (view.time < hold_first) order.velocity = Vector2d::Zero();
    out.push_back(steering_.command(view, robot, order));
  }

 private:
  using Vector2d = world::Vector2d;
  skills::TurnCircle circle_;
  double angle_;
  double start_ = 0;
  skills::Steering steering_;
};

}  // namespace

TurnTry try_turn(const skills::TurnCircle& circle, double angle, std::uint64_t seed, const char* realism) {
  Side side;
  side.robots = {1};
  side.make = [&](const kit::Setup&) { return std::make_unique<Turner>(circle, angle); };
  Arena arena(side, {}, seed, realism);
  engine::Engine& engine = arena.engine();
  engine.put_robot({world::Team::Yellow, 1}, {0.5, 0.4}, 0.3);
  engine.place_ball(world::Vector2d(0.5, 0.4) + world::direction(0.3) * 0.0955);
  arena.tell({world::CommandKind::Start});

  TurnTry result;
  result.kept = true;
  world::Vector2d began = world::Vector2d::Zero();
  double aligned_at = -1;
  while (world::seconds(engine.time()) < hold_first + 3) {
    arena.tick();
    const double now = world::seconds(engine.time());
    const truth::Robot& robot = engine.truth().robots.front();
    const world::Vector2d ball = engine.truth().ball.position.head<2>();
    if (now < hold_first) {
      began = ball;
      continue;
    }
    result.ball_moved = std::max(result.ball_moved, (ball - began).norm());
    // 20 mm of air between front and ball: let go.
    const world::Vector2d local = world::rotated(ball - robot.position, -robot.orientation);
    if (local.x() > 0.0945 + 0.02 || std::abs(local.y()) > 0.045) {
      result.kept = false;
      break;
    }
    const double left = std::abs(world::wrap_angle(0.3 + angle - robot.orientation));
    if (aligned_at < 0 && left < 0.1) aligned_at = now;
    if (aligned_at >= 0 && now > aligned_at + 0.1) break;
  }
  result.time = (aligned_at < 0 ? 3 + hold_first : aligned_at) - hold_first;
  if (aligned_at < 0) result.kept = false;
  return result;
}

}  // namespace support

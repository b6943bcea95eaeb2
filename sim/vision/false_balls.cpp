#include "sim/vision/false_balls.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/world/time.h"

namespace vision {
namespace {

using world::Vector2d;
using world::Vector3d;

constexpr double share_on_robots = 0.5;
constexpr double smallest = 0.25;  // share of a ball's disc

// What is drawn in the image in which one begins.
enum Purpose : unsigned { Begins, Lasts, OnRobot, Which, First, Second, Size };

std::uint32_t whole(double share, std::size_t count) {
  return static_cast<std::uint32_t>(share * static_cast<double>(count));
}

}  // namespace

FalseBalls::FalseBalls(const Params& params, const Area& area, double ball_radius,
                       const world::RobotSpecs& body, Draws draws)
    : probability_(params.false_ball_rate * world::tick_length),
      shortest_(params.false_ball_shortest),
      longest_(params.false_ball_longest),
      area_(area),
      ball_radius_(ball_radius),
      robot_radius_(body.radius),
      robot_height_(body.height),
      draws_(draws) {}

FalseBalls::FalseBall FalseBalls::begin(std::uint32_t image,
                                        std::span<const truth::Robot* const> in_view) const {
  const auto draw = [&](Purpose purpose) { return draws_.uniform(image, 0, purpose); };
  const auto lengths = static_cast<std::size_t>(longest_ - shortest_ + 1);
  FalseBall ball;
  ball.begin = image;
  ball.end = image + static_cast<std::uint32_t>(shortest_) + whole(draw(Lasts), lengths);
  ball.size = smallest + (1 - smallest) * draw(Size);
  if (draw(OnRobot) < share_on_robots && !in_view.empty()) {
    ball.robot = in_view[whole(draw(Which), in_view.size())]->id;
    ball.place =
        robot_radius_ * std::sqrt(draw(First)) * world::direction(2 * std::numbers::pi * draw(Second));
  } else {
    ball.place = area_.at(draw(First), draw(Second));
  }
  return ball;
}

const std::vector<FalseBalls::Seen>& FalseBalls::update(std::uint32_t image,
                                                        std::span<const truth::Robot* const> in_view) {
  seen_.clear();
  if (probability_ == 0) return seen_;
  std::erase_if(alive_, [&](const FalseBall& ball) { return ball.end == image; });
  if (draws_.uniform(image, 0, Begins) < probability_) alive_.push_back(begin(image, in_view));
  for (const FalseBall& ball : alive_) {
    Vector3d place(ball.place.x(), ball.place.y(), ball_radius_);
    if (ball.robot) {
      const auto robot = std::find_if(in_view.begin(), in_view.end(),
                                      [&](const truth::Robot* other) { return other->id == *ball.robot; });
      if (robot == in_view.end()) continue;
      const Vector2d on_field = (*robot)->position + world::rotated(ball.place, (*robot)->orientation);
      place = {on_field.x(), on_field.y(), robot_height_};
    }
    seen_.push_back({place, ball.size, image - ball.begin});
  }
  return seen_;
}

}  // namespace vision

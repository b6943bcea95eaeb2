#include "tests/autoref/calibrate/scene.h"

#include <cmath>
#include <map>
#include <optional>

#include "sim/world/random.h"

namespace scene {
namespace {

using world::Vector2d;

struct RobotPose {
  world::RobotId id;
  Vector2d position;
  double orientation;
};

Vector2d ball_at(double t) { return {4.2 * std::sin(0.31 * t), 2.7 * std::sin(0.47 * t + 1)}; }

std::vector<RobotPose> robots_at(double t) {
  std::vector<RobotPose> robots;
  for (int i = 0; i < 8; ++i) {
    const Vector2d centre(-3.6 + 1.03 * i, i % 2 == 0 ? 0.9 : -0.9);
    const double angle = 0.9 * t + i;
    robots.push_back({{i < 4 ? world::Team::Yellow : world::Team::Blue, static_cast<std::uint8_t>(i)},
                      centre + 0.9 * world::direction(angle),
                      world::wrap_angle(angle * 1.7)});
  }
  return robots;
}

class Channel {
 public:
  bool lost(const Losses& losses, world::RandomStream& random) {
    burst_ = burst_ ? random.uniform() >= 1 / losses.burst_length : random.uniform() < losses.burst_start;
    return random.uniform() < losses.missing || burst_;
  }

 private:
  bool burst_ = false;
};

struct FalseBall {
  int images_left;
  Vector2d place;
  std::optional<std::size_t> robot;
};

}  // namespace

world::Geometry geometry(int cameras) {
  world::Geometry geometry;
  geometry.cameras = world::camera_grid(geometry.field, cameras, 4.2);
  return geometry;
}

std::vector<world::Detection> images(int cameras, double seconds, const Errors& errors, std::uint64_t seed) {
  world::RandomStream random(seed, "scene");
  const auto noise = [&](double sigma) {
    return Vector2d(sigma * random.gaussian(), sigma * random.gaussian());
  };
  const std::vector<world::Camera> set_up = geometry(cameras).cameras;
  std::vector<std::map<int, Channel>> channels(set_up.size());
  std::vector<std::vector<FalseBall>> false_balls(set_up.size());
  std::vector<world::Detection> all;
  for (int tick = 0; tick < static_cast<int>(seconds * 60); ++tick) {
    for (std::size_t c = 0; c < set_up.size(); ++c) {
      const Vector2d foot = set_up[c].position.head<2>();
      const auto sees = [&](const Vector2d& p) {
        return p.x() * foot.x() > -overlap * std::abs(foot.x()) &&
               (std::abs(foot.y()) < 0.1 || p.y() * foot.y() > -overlap * std::abs(foot.y()));
      };
      world::Detection image;
      image.camera = set_up[c].id;
      image.frame_number = static_cast<std::uint32_t>(tick);
      image.t_capture = world::whole_microseconds(world::tick_time(tick, static_cast<int>(c % 4)));
      image.t_sent = world::whole_microseconds(image.t_capture + world::from_seconds(errors.delay));
      const double t = world::seconds(image.t_capture);
      const Vector2d offset = errors.offsets.empty() ? Vector2d(0, 0) : errors.offsets[c];
      const auto add_ball = [&](const Vector2d& place) {
        world::DetectedBall& ball = image.balls.emplace_back();
        ball.position = world::as_on_wire(Vector2d(place + offset + noise(errors.ball_sigma)));
        ball.area = static_cast<std::uint32_t>(
            std::lround(std::max(0.0, 100 + errors.area_sigma * random.gaussian())));
      };
      const Vector2d ball = ball_at(t);
      const bool ball_lost = channels[c][-1].lost(errors.ball, random);
      if (sees(ball) && !ball_lost) add_ball(ball);

      const std::vector<RobotPose> robots = robots_at(t);
      for (std::size_t r = 0; r < robots.size(); ++r) {
        const bool lost = channels[c][static_cast<int>(r)].lost(errors.robot, random);
        if (!sees(robots[r].position) || lost) continue;
        world::DetectedRobot& robot = image.robots.emplace_back();
        robot.team = robots[r].id.team;
        robot.number = robots[r].id.number;
        if (random.uniform() < errors.misread) robot.number = static_cast<std::uint8_t>(random.below(16));
        if (random.uniform() < errors.unread) robot.number.reset();
        robot.position = world::as_on_wire(Vector2d(robots[r].position + offset + noise(errors.robot_sigma)));
        robot.orientation = world::as_float(
            world::wrap_angle(robots[r].orientation + errors.orientation_sigma * random.gaussian()));
      }

      if (random.uniform() < errors.false_ball_rate / 60) {
        const int lengths = errors.false_ball_longest - errors.false_ball_shortest + 1;
        FalseBall& made = false_balls[c].emplace_back();
        made.images_left =
            errors.false_ball_shortest + static_cast<int>(random.below(static_cast<std::uint64_t>(lengths)));
        made.place = foot + Vector2d(random.uniform() - 0.5, random.uniform() - 0.5) * 2;
        if (random.uniform() < 0.5) {
          const std::size_t rider = random.below(robots.size());
          if (sees(robots[rider].position)) made.robot = rider;
        }
      }
      for (FalseBall& made : false_balls[c]) {
        --made.images_left;
        add_ball(made.robot ? Vector2d(robots[*made.robot].position) : made.place);
      }
      std::erase_if(false_balls[c], [](const FalseBall& made) { return made.images_left == 0; });
      all.push_back(image);
    }
  }
  return all;
}

}  // namespace scene

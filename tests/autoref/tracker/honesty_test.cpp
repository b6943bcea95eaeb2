#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <map>
#include <numbers>
#include <optional>

#include "autoref/tracker/ball_filter.h"
#include "autoref/tracker/robot_filter.h"
#include "autoref/tracker/tracker.h"
#include "sim/world/random.h"
#include "teams/reference/reference_team.h"
#include "tests/teams/support/arena.h"

namespace tracker {
namespace {

constexpr double bound_2 = 13.816;  // chi-square, 2 degrees of freedom, 99.9 %

struct Sum {
  double nis = 0;
  int count = 0, above = 0;
  void add(double value) {
    nis += value;
    ++count;
    above += value > bound_2;
  }
  double mean() const { return nis / (2.0 * count); }  // per degree of freedom
  double share() const { return static_cast<double>(above) / count; }
};

/// The demand of the design: mean 0.8 to 1.25 and at most 1 % above the 99.9 % bound.
void expect_honest(const char* what, const Sum& sum) {
  std::printf("%s: mean NIS %.3f per degree of freedom, above the 99.9 %% bound %.2f %% of %d\n", what,
              sum.mean(), 100 * sum.share(), sum.count);
  EXPECT_GT(sum.mean(), 0.8);
  EXPECT_LT(sum.mean(), 1.25);
  EXPECT_LT(sum.share(), 0.01);
}

// Sensors of `measured` with all their errors: offsets of 10 mm, which the tracker learns and which are taken
// off, occlusion, a tick's delay. The filters are those of the tracker.
TEST(Honesty, BallRollingFreelyAcrossCameras) {
  engine::Model model;
  model.realism = engine::realism("measured");
  model.robots.yellow = engine::standard_robots(world::Team::Yellow, {0, 1});
  model.robots.blue = engine::standard_robots(world::Team::Blue, {0, 1});
  model.seed = 11;
  engine::Engine engine(model);
  const world::Geometry& geometry = engine.model().geometry;
  Tracker tracker(geometry);
  engine.put_robot({world::Team::Yellow, 0}, {-3.2, 0.05}, 0);  // in overlaps, out of the ball's way
  engine.put_robot({world::Team::Yellow, 1}, {0.05, 2.9}, 0);
  engine.put_robot({world::Team::Blue, 0}, {3.2, -0.05}, 3);
  engine.put_robot({world::Team::Blue, 1}, {-0.05, -2.9}, 3);
  for (int tick = 0; tick < 120; ++tick) {
    engine.step({});
    tracker.update(engine.detections());
  }
  world::RandomStream random(4, "honest");
  Sum sum;
  for (int roll = 0; roll < 60; ++roll) {
    const double heading = 2 * std::numbers::pi * random.uniform();
    truth::Ball ball = engine.truth().ball;
    ball.position << -1.5 * world::direction(heading), geometry.field.ball_radius;
    ball.velocity << (0.5 + 3 * random.uniform()) * world::direction(heading), 0;
    ball.spin.setZero();
    engine.put_ball(ball);
    std::optional<BallFilter> filter;
    world::Time last;
    int seen = 0;
    for (int tick = 0; tick < 80; ++tick) {
      engine.step({});
      tracker.update(engine.detections());
      if (tick < 3) continue;  // images of before are still under way
      for (const world::Detection& image : engine.detections()) {
        for (const world::DetectedBall& report : image.balls) {
          const Vector2d place = report.position - tracker.bias().applied(image.camera);
          if (std::abs(place.x()) > 2.8 || std::abs(place.y()) > 2.5) continue;
          if (!filter) {
            filter.emplace(geometry, Params{});
            filter->start(place, Vector2d::Zero(), 5);
          } else {
            filter->predict(world::seconds(image.t_capture - last), false);
            if (++seen > 4) sum.add(filter->nis(place));
            filter->update(place);
          }
          last = image.t_capture;
        }
      }
    }
  }
  expect_honest("ball, offsets learnt", sum);
}

TEST(Honesty, RobotsOfAGameWithoutContact) {
  support::Side side;
  side.make = [](const kit::Setup& setup) {
    return std::make_unique<reference::ReferenceTeam>(setup, reference::Parameters{}, false);
  };
  support::Arena arena(side, side, 3, "measured");
  arena.start_referee(std::chrono::seconds{40});
  Tracker tracker(arena.engine().model().geometry);
  struct Track {
    std::optional<RobotFilter> filter;
    world::Time last;
    int seen = 0;
  };
  std::map<world::RobotId, Track> tracks;
  Sum sum;
  while (arena.tick()) {
    tracker.update(arena.engine().detections());
    for (const world::Detection& image : arena.engine().detections()) {
      for (const world::DetectedRobot& robot : image.robots) {
        const world::RobotId id{robot.team, *robot.number};
        Track& track = tracks[id];
        const Vector2d place = robot.position - tracker.bias().applied(image.camera);
        bool free = world::seconds(image.t_capture) > 3;
        for (const truth::Robot& other : arena.engine().truth().robots) {
          if (other.id != id && (other.position - place).norm() < 0.3) free = false;
        }
        if (!free || world::seconds(image.t_capture - track.last) > 0.05) {
          track.filter.reset();
        }
        if (!track.filter) {
          track.filter.emplace(Params{});
          track.filter->start(place, robot.orientation, Vector2d::Zero(), 3);
          track.seen = 0;
        } else {
          track.filter->predict(world::seconds(image.t_capture - track.last));
          if (++track.seen > 4) sum.add(track.filter->nis(place));
          track.filter->update(place, robot.orientation);
        }
        track.last = image.t_capture;
      }
    }
  }
  expect_honest("robots, offsets learnt", sum);
}

}  // namespace
}  // namespace tracker

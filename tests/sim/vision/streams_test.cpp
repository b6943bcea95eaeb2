// What is random in one place does not shift what is random in another, and does not change without need.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "tests/sim/vision/scene.h"

namespace {

using vision::Cameras;
using vision::Params;

std::vector<truth::Robot> six_robots() {
  std::vector<truth::Robot> robots;
  for (int k = 0; k < 6; ++k) {
    robots.push_back(scene::robot_at(-2.0 + 0.8 * k, 0.3 * k - 0.9, k, k % 3,
                                     k < 3 ? world::Team::Yellow : world::Team::Blue));
  }
  return robots;
}

constexpr Params noisy{.ball_sigma = 0.0005,
                       .robot_sigma = 0.00055,
                       .orientation_sigma = 0.0035,
                       .ball_missing = 0.05,
                       .robot_missing = 0.02};

// A stored result: the number is from the cameras as they were before they had any other errors than these.
TEST(Streams, NoiseAndSingleLossesAreThoseOfTheFirstCameras) {
  Cameras cameras(scene::geometry(), noisy, 42);
  std::uint64_t hash = 14695981039346656037ULL;  // FNV-1a over whole numbers
  const auto add = [&](double v) { hash = (hash ^ std::bit_cast<std::uint64_t>(v)) * 1099511628211ULL; };
  for (int i = 0; i < 300; ++i) {
    const truth::Ball ball = scene::ball_at(0.1 - 0.01 * i, 0.05, (i % 3) * 0.2);
    for (const auto& frame : scene::tick(cameras, i, ball, six_robots())) {
      for (const auto& seen : frame.balls) {
        add(seen.position.x());
        add(seen.position.y());
      }
      for (const auto& seen : frame.robots) {
        add(seen.position.x());
        add(seen.position.y());
        add(*seen.orientation);
      }
    }
  }
  EXPECT_EQ(hash, 105418127330876734ULL);
}

// The true ball is told from false ones by its place.
const world::DetectedBall* true_ball(const world::Detection& frame) {
  for (const auto& ball : frame.balls) {
    if ((ball.position - world::Vector2d(0.05, 0.05)).norm() < 0.1) return &ball;
  }
  return nullptr;
}

// Each of these adds or takes away something; whatever is still there is where it was, plus a constant.
TEST(Streams, OneParameterShiftsNothingElse) {
  std::vector<Params> others(8, noisy);
  others[0].ball_burst_start = 0.1;
  others[1].robot_burst_start = 0.1;
  others[2].false_ball_rate = 20;
  others[3].misread_id = 0.3;
  others[4].unread_id = 0.3;
  others[5].area_sigma = 5;
  others[6].regions = 2;
  others[6].region_radius = 20;
  others[6].region_missing = 0.5;
  others[7].visible_share = 0.4;
  for (const Params& params : others) {
    Cameras plain(scene::geometry(), noisy, 42), other(scene::geometry(), params, 42);
    int balls = 0, robots = 0;
    for (int i = 0; i < 100; ++i) {
      const auto a = scene::tick(plain, i, scene::ball_at(0.05, 0.05), six_robots());
      const auto b = scene::tick(other, i, scene::ball_at(0.05, 0.05), six_robots());
      for (std::size_t c = 0; c < 4; ++c) {
        const auto* was = true_ball(a[c]);
        const auto* is = true_ball(b[c]);
        if (was && is) {
          ++balls;
          EXPECT_EQ(was->position, is->position);
        }
        if (params.ball_burst_start == 0 && params.region_missing == 0) {
          EXPECT_EQ(was == nullptr, is == nullptr);
        }
        for (const auto& robot : b[c].robots) {
          ++robots;
          EXPECT_EQ(std::count_if(a[c].robots.begin(), a[c].robots.end(),
                                  [&](const auto& one) { return one.position == robot.position; }),
                    1);
        }
        if (params.robot_burst_start == 0) {
          EXPECT_EQ(a[c].robots.size(), b[c].robots.size());
        }
      }
    }
    EXPECT_GT(balls, 100);
    EXPECT_GT(robots, 400);
  }
}

TEST(Streams, BurstsStayWhereTheyAreWhenOtherLossesChange) {
  const auto lost = [](double missing) {
    Cameras cameras(scene::geometry(), Params{.ball_missing = missing, .ball_burst_start = 0.05}, 3);
    std::vector<bool> result;
    for (int i = 0; i < 300; ++i) {
      result.push_back(scene::tick(cameras, i, scene::ball_at(-2, -1))[0].balls.empty());
    }
    return result;
  };
  const auto few = lost(0), more = lost(0.3);
  for (std::size_t i = 0; i < few.size(); ++i) {
    if (few[i]) {
      EXPECT_TRUE(more[i]);
    }
  }
}

Params everything() {
  Params params = noisy;
  params.delay = 2;
  params.bias_sigma = 0.01;
  params.area_sigma = 5;
  params.visible_share = 0.4;
  params.ball_burst_start = params.robot_burst_start = 0.05;
  params.regions = 2;
  params.region_missing = 0.3;
  params.region_offset = 0.02;
  params.false_ball_rate = 10;
  params.misread_id = params.unread_id = 0.1;
  return params;
}

void expect_same(const std::vector<world::Detection>& a, const std::vector<world::Detection>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t c = 0; c < a.size(); ++c) {
    EXPECT_EQ(a[c].frame_number, b[c].frame_number);
    ASSERT_EQ(a[c].balls.size(), b[c].balls.size());
    ASSERT_EQ(a[c].robots.size(), b[c].robots.size());
    for (std::size_t k = 0; k < a[c].balls.size(); ++k) {
      EXPECT_EQ(a[c].balls[k].position, b[c].balls[k].position);
      EXPECT_EQ(a[c].balls[k].area, b[c].balls[k].area);
    }
    for (std::size_t k = 0; k < a[c].robots.size(); ++k) {
      EXPECT_EQ(a[c].robots[k].position, b[c].robots[k].position);
      EXPECT_EQ(a[c].robots[k].number, b[c].robots[k].number);
    }
  }
}

TEST(Streams, ACopyGoesOnAsTheOriginalDoes) {
  Cameras original(scene::geometry(), everything(), 11);
  for (int i = 0; i < 101; ++i) scene::tick(original, i, scene::ball_at(-1, 0), six_robots());
  const Cameras copy = original;
  std::vector<std::vector<world::Detection>> expected;
  for (int i = 101; i < 200; ++i) {
    expected.push_back(scene::tick(original, i, scene::ball_at(-1, 0), six_robots()));
  }
  Cameras again(scene::geometry(), Params{}, 1);
  again = copy;
  for (int i = 101; i < 200; ++i) {
    expect_same(scene::tick(again, i, scene::ball_at(-1, 0), six_robots()),
                expected[static_cast<std::size_t>(i - 101)]);
  }
}

TEST(Streams, EverythingAtOnceIsFiniteAndOnTheWire) {
  for (const int count : {1, 2, 4, 6, 8}) {
    Cameras cameras(scene::geometry(count), everything(), 12);
    for (int i = 0; i < 300; ++i) {
      const truth::Ball ball = scene::ball_at(5 * std::sin(0.1 * i), 3.5 * std::cos(0.07 * i),
                                              5 * std::max(0.0, std::sin(0.3 * i)));
      for (const auto& frame : scene::tick(cameras, i, ball, six_robots())) {
        for (const auto& seen : frame.balls) {
          EXPECT_TRUE(seen.position.allFinite() && seen.pixel.allFinite() && std::isfinite(seen.confidence));
          EXPECT_EQ(seen.position, world::as_on_wire(seen.position));
          EXPECT_EQ(seen.pixel.x(), world::as_float(seen.pixel.x()));
          EXPECT_EQ(seen.confidence, world::as_float(seen.confidence));
        }
        for (const auto& seen : frame.robots) {
          EXPECT_TRUE(seen.position.allFinite() && seen.pixel.allFinite());
          EXPECT_EQ(seen.position, world::as_on_wire(seen.position));
          EXPECT_EQ(seen.pixel.y(), world::as_float(seen.pixel.y()));
          EXPECT_EQ(seen.confidence, world::as_float(seen.confidence));
          EXPECT_LE(seen.number.value_or(0), 15);
        }
      }
    }
  }
}

}  // namespace

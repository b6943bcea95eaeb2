#include "autoref/touch/retrace.h"

#include <gtest/gtest.h>

#include <functional>
#include <random>

#include "autoref/touch/free_ball.h"

namespace touch {
namespace {

constexpr double noise = 0.0005;  // [m] of `measured`

struct Placed {
  world::RobotId id;
  Vector2d position = Vector2d::Zero();
  double orientation = 0;
};

/// Images of a ball that is at `course(t)`, among standing robots.
/// @param told  who touched it at first
Retraced way(
    double seconds, const std::function<Vector2d(double)>& course, const std::vector<Placed>& robots,
    std::size_t told, const std::function<bool(double)>& hidden = [](double) { return false; },
    const world::Geometry& geometry = {}) {
  Trail trail{geometry};
  std::mt19937_64 engine(7);
  std::normal_distribution<double> normal(0, noise);
  Vector2d last = course(0);
  for (int k = 0; k * world::tick_length < seconds; ++k) {
    const double t = k * world::tick_length;
    const Vector2d ball = course(t);
    world::TrackedFrame frame;
    frame.time = world::tick_time(k + 1);
    frame.ball.emplace();
    frame.ball->position.head<2>() = ball;
    frame.ball->velocity.head<2>() = (ball - last) / world::tick_length;
    frame.ball->observed = !hidden(t);
    last = ball;
    world::Detection image;
    image.t_capture = frame.time;
    for (const Placed& robot : robots) {
      frame.robots.push_back({robot.id, robot.position, robot.orientation});
      image.robots.push_back({robot.id.team, robot.id.number, robot.position, robot.orientation});
    }
    if (!hidden(t)) image.balls.push_back({ball + Vector2d(normal(engine), normal(engine))});
    trail.add(frame, std::span(&image, 1), told, 1);
  }
  return retrace(trail, world::Field{}, noise);
}

const world::RobotId yellow_1{world::Team::Yellow, 1};
const world::RobotId blue_2{world::Team::Blue, 2};

/// Straight with a bend of `turn` [rad] at the origin after 0.5 s.
std::function<Vector2d(double)> bent(double speed, double turn) {
  return [=](double t) {
    const double way = speed * (t - 0.5);
    return way < 0 ? Vector2d(way, 0) : Vector2d(way * world::direction(turn));
  };
}
/// Its hull against the ball at the origin, from below: with its round side.
Placed beside_the_origin(double gap) { return {blue_2, {0, -(0.09 + 0.0215 + gap)}, -1.57}; }

TEST(Retrace, LeavesItToWhoeverTouchedItLastWhenTheBallRollsPast) {
  for (const double gap : {0.005, 0.02, 0.06}) {
    const Retraced found = way(1, bent(2, 0), {beside_the_origin(gap)}, slot(yellow_1));
    EXPECT_GT(found.probability[slot(yellow_1)], 0.9) << gap;
  }
}

// 0.05 rad at 2 m/s are 0.1 m/s, 4.6 mN s: far above the noise of ten images on either side.
TEST(Retrace, SeesAGrazeInTheCourse) {
  const Retraced found = way(1, bent(2, 0.05), {beside_the_origin(0)}, slot(yellow_1));
  EXPECT_GT(found.probability[slot(blue_2)], 0.95);
  EXPECT_NEAR(world::seconds(found.time[slot(blue_2)]), 0.5 + 1.0 / 60, 0.04);  // two images
  EXPECT_LT(found.place[slot(blue_2)].norm(), 0.05);                            // a ball radius and an image
}

// The same bend without a robot there is nobody's touch.
TEST(Retrace, GivesABendToNobodyWhenNobodyIsThere) {
  const Retraced found = way(1, bent(2, 0.3), {{blue_2, {0, -0.35}, 0}}, slot(yellow_1));
  EXPECT_GT(found.probability[slot(yellow_1)], 0.95);
}

// A kick and two images later a deflection: no six images have one bend.
TEST(Retrace, TellsTwoTouchesOneAfterTheOther) {
  const Vector2d start(0, 0);
  const auto course = [](double t) {
    if (t < 0.5) return Vector2d(0, 0);
    const double way = 5 * (t - 0.5);
    if (way < 0.15) return Vector2d(way, 0);
    return Vector2d(Vector2d(0.15, 0) + (way - 0.15) * 0.9 * world::direction(0.25));
  };
  const Placed kicker{yellow_1, {-0.073 - 0.0215, 0}, 0};
  const Placed other{blue_2, Vector2d(0.15, 0) + 0.1115 * world::direction(-1.45), -1.45};
  const Retraced found = way(1, course, {kicker, other}, slot({world::Team::Blue, 9}));
  EXPECT_GT(found.probability[slot(blue_2)], 0.9);
  // And the kick alone, past the same robot a little farther away.
  const auto straight = [](double t) { return Vector2d(t < 0.5 ? 0 : 5 * (t - 0.5), 0); };
  Placed farther = other;
  farther.position += 0.02 * world::direction(-1.45);
  const Retraced kicked = way(1, straight, {kicker, farther}, slot({world::Team::Blue, 9}));
  EXPECT_GT(kicked.probability[slot(yellow_1)], 0.9);
}

// Behind the line a touch changes the course, but not who was last before.
TEST(Retrace, DoesNotCountTouchesOfABallThatIsOut) {
  const double out = world::Field{}.half_width() + 0.0215;
  const auto course = [out](double by) {
    return [=](double t) {
      const Vector2d ball = bent(2, 0.6)(t);
      return Vector2d(ball.x(), out + by + ball.y());
    };
  };
  for (const double by : {0.06, -0.06}) {
    Placed robot = beside_the_origin(0);
    robot.position.y() += out + by;
    const Retraced found = way(0.8, course(by), {robot}, slot(yellow_1));
    EXPECT_GT(found.probability[slot(by > 0 ? yellow_1 : blue_2)], 0.9) << by;
  }
}

// A ball seen inside a hull is in the air over it.
TEST(Retrace, DoesNotTakeAFlightOverARobotForATouch) {
  const Retraced found = way(1, bent(2, 0.05), {{blue_2, {0, 0}, -1.57}}, slot(yellow_1));
  EXPECT_GT(found.probability[slot(yellow_1)], 0.9);
}

// A rolling ball comes off a hull with a hop of 26 mm. A camera that stands 2 m beside it and 4 m
// high shows it up to 13 mm aside, and where it lands a bend of 0.3 m/s, as if the robot that
// stands there had pushed it.
TEST(Retrace, DoesNotTakeTheEndOfAHopForATouch) {
  world::Geometry geometry;
  geometry.cameras = {{.id = 1, .position = {-0.2, -2, 4}}};  // images of 0: nothing is hidden in them
  const auto course = [&](double t) {
    FreeBall ball{.velocity = {2.5, 0}, .spin = {2.5, 0}};
    Vector2d place(2.5 * (t - 0.5), 0);
    if (t > 0.5) {
      bounce(ball, {-1, 0}, Vector2d::Zero(), 0.57);
      place = move(ball, t - 0.5, {});
    }
    const world::Vector3d& camera = geometry.cameras.front().position;
    return Vector2d(place + (place - camera.head<2>()) * (ball.height / (camera.z() - ball.height)));
  };
  const Placed hit{blue_2, {0.1115, 0}, 0};
  const Placed beside{yellow_1, {-0.21, -0.1145}, -1.57};  // 3 mm from where it lands
  const auto never = [](double) { return false; };
  const Retraced found = way(1, course, {hit, beside}, slot({world::Team::Blue, 9}), never, geometry);
  EXPECT_GT(found.probability[slot(blue_2)], 0.75);  // so near, a graze is possible whether it hops or not
}

TEST(Retrace, SaysNothingWithoutABall) {
  Trail trail{world::Geometry{}};
  const Retraced found = retrace(trail, world::Field{}, noise);
  for (const double probability : found.probability) EXPECT_EQ(probability, 0);
}

// Nothing is drawn at random, and left is like right.
TEST(Retrace, IsTheSameAgain) {
  const Retraced once = way(1, bent(2, 0.02), {beside_the_origin(0.002)}, slot(yellow_1));
  const Retraced again = way(1, bent(2, 0.02), {beside_the_origin(0.002)}, slot(yellow_1));
  EXPECT_EQ(once.probability, again.probability);
}

}  // namespace
}  // namespace touch

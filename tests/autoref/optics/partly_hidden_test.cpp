#include "autoref/optics/partly_hidden.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "sim/truth/truth.h"
#include "sim/vision/occlusion.h"

namespace optics {
namespace {

// Half a disc has its middle 4 r / 3 pi from the edge; a whole one in its own middle; a sliver at the rim.
TEST(ShiftOfVisible, IsThatOfCircularSegments) {
  EXPECT_NEAR(shift_of_visible(0), 4 / (3 * std::numbers::pi), 1e-12);
  EXPECT_NEAR(shift_of_visible(1), 0, 1e-12);
  EXPECT_NEAR(shift_of_visible(-0.999), 1, 0.001);
}

// Second method: the visible part summed in strips. A strip of 1e-4 leaves out 1e-6 of the area at the rim.
TEST(ShiftOfVisible, AgreesWithStrips) {
  for (double u = -0.9; u < 1; u += 0.1) {
    double area = 0, moment = 0;
    constexpr double strip = 1e-4;
    for (double x = -u + strip / 2; x < 1; x += strip) {
      const double width = 2 * std::sqrt(std::max(0.0, 1 - x * x));
      area += width * strip;
      moment += x * width * strip;
    }
    EXPECT_NEAR(shift_of_visible(u), moment / area, 1e-4) << u;
  }
}

// Bisection in twenty steps: 2^-20 of the range.
TEST(Uncovered, IsTheInverse) {
  for (double u = -1; u <= 1; u += 0.05) EXPECT_NEAR(uncovered(u + shift_of_visible(u)), u, 4e-6) << u;
  EXPECT_NEAR(uncovered(2), 1, 4e-6);
  EXPECT_NEAR(uncovered(-1), -1, 4e-6);
}

struct Scene {
  world::Geometry geometry;
  world::Vector3d camera{-2.25, 1.5, 4.0};
  vision::Occlusion occlusion{world::RobotSpecs{}, 0.0215};

  Scene() { geometry.cameras = {{.id = 3, .position = camera}}; }

  struct View {
    double share;
    Vector2d seen;
    WholeBall whole;
  };
  /// A ball against a robot's hull, `gap` [m] away at an angle in the robot's frame.
  View look(const Vector2d& place, double orientation, double angle, double gap) const {
    truth::Robot robot;
    robot.position = place;
    robot.orientation = orientation;
    const Vector2d direction = world::direction(orientation + angle);
    const bool front = std::abs(angle) < std::atan2(std::sqrt(0.09 * 0.09 - 0.073 * 0.073), 0.073);
    const double hull = front ? (0.073 + 0.0215 + gap) / std::cos(angle) : 0.09 + 0.0215 + gap;
    const Vector2d ball = place + hull * direction;
    const vision::BallView view = occlusion.view(camera, {ball.x(), ball.y(), 0.0215}, std::span(&robot, 1));
    const Vector2d foot = camera.head<2>();
    const Vector2d seen =
        foot + (view.center.head<2>() - foot) * ((camera.z() - 0.0215) / (camera.z() - view.center.z()));
    PartlyHidden partly(geometry.field, geometry.cameras[0], seen);
    partly.beside(robot.position, robot.orientation);
    return {view.share, seen, partly.whole()};
  }
};

// Against the exact view of the simulator's cameras, with balls 0 to 10 mm from the hull on all sides, at
// places up to 3 m from the camera's foot. The straight edge and the ball's tilted disc cost a few
// millimetres when most of the ball is hidden: then the shift itself is over 10 mm.
TEST(PartlyHidden, IsTakenBackToWhereItIs) {
  const Scene scene;
  int hidden = 0;
  double before = 0, after = 0;
  for (const Vector2d& place : {Vector2d(0, 0), Vector2d(-2, 2.5), Vector2d(-4.2, -1), Vector2d(-1.5, 1.2)}) {
    for (double angle = -3; angle <= 3.01; angle += 0.25) {
      for (const double gap : {0.0, 0.004, 0.01}) {
        for (const double orientation : {0.0, 1.3, -2.2}) {
          const Scene::View view = scene.look(place, orientation, angle, gap);
          if (view.share < 0.15 || view.share >= 1) continue;  // not seen, or seen whole
          const bool front = std::abs(angle) < std::atan2(std::sqrt(0.09 * 0.09 - 0.073 * 0.073), 0.073);
          const double hull = front ? (0.073 + 0.0215 + gap) / std::cos(angle) : 0.09 + 0.0215 + gap;
          const Vector2d ball = place + hull * world::direction(orientation + angle);
          ++hidden;
          const double off = (view.whole.position - ball).norm();
          before += (view.seen - ball).norm();
          after += off;
          EXPECT_LT(off, 0.005) << place.transpose() << " angle " << angle << " gap " << gap << " share "
                                << view.share << " seen off by " << (view.seen - ball).norm();
        }
      }
    }
  }
  EXPECT_GT(hidden, 100);
  EXPECT_LT(after, before / 3);  // measured: 0.30
}

// A ball between camera and robot, or clear of its shadow, is left alone.
TEST(PartlyHidden, LeavesWholeBallsAlone) {
  const Scene scene;
  const Scene::View in_front = scene.look({0, 1.5}, std::numbers::pi, 0, 0.001);  // the camera is at -x
  EXPECT_DOUBLE_EQ(in_front.share, 1);
  EXPECT_EQ(in_front.whole.position, in_front.seen);
  const Scene::View far = scene.look({0, 1.5}, 0, 0, 0.3);
  EXPECT_EQ(far.whole.position, far.seen);
}

// Over a robot it is in the air, and a camera as low as robots tells nothing.
TEST(PartlyHidden, LeavesWhatItCannotKnow) {
  const Scene scene;
  PartlyHidden over(scene.geometry.field, scene.geometry.cameras[0], {0.03, 0});
  over.beside({0, 0}, 0);
  EXPECT_EQ(over.whole().position, Vector2d(0.03, 0));
  world::Camera low = scene.geometry.cameras[0];
  low.position.z() = 0.2;
  PartlyHidden seen(scene.geometry.field, low, {0.1, 0});
  seen.beside({0, 0}, 0);
  EXPECT_EQ(seen.whole().position, Vector2d(0.1, 0));
}

}  // namespace
}  // namespace optics

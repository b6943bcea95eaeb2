// Fast balls against everything that has to stop them, over angles and sub-frame phases.

#include <gtest/gtest.h>

#include "tests/sim/physics/sweeps.h"

namespace {

using world::Vector2d;

// Chips at `speed`, raised by `angle`, at a robot, which they may fly over but not through.
Sweep chips_at_robot(double speed, double angle) {
  Sweep sweep;
  for (int side = 0; side < 8; ++side) {
    for (int distance = 0; distance < 12; ++distance) {  // so that they arrive at every height
      for (int phase = 0; phase < sweep_phases / 4; ++phase) {
        const Vector2d direction = world::direction(side * 2 * M_PI / 8 + 0.1);
        const Vector2d across{-direction.y(), direction.x()};
        Arena arena({{{0, 0}, 0}});
        const Vector2d from =
            start({0, 0}, direction, 0.15 + 0.12 * distance, speed, 4 * phase, world::substep_length);
        const Vector2d flat = direction * (speed * std::cos(angle));
        arena.place({from.x(), from.y(), 0.0215}, {flat.x(), flat.y(), speed * std::sin(angle)});
        double highest = 0;
        bool passed = false;
        for (int i = 0; i < 180; ++i) {
          arena.step();
          const world::Vector3d& ball = arena.ball().position;
          const truth::Robot robot = arena.robot(0);
          const Vector2d from_robot = ball.head<2>() - robot.position;
          const double beside = 0.0215 - physics::hull_distance(arena.specs[0], robot.position,
                                                                robot.orientation, ball.head<2>());
          const double above = 0.15 + 0.0215 - ball.z();
          sweep.worst = std::max(sweep.worst, std::min(beside, above));
          if (from_robot.dot(direction) > -0.12 && from_robot.dot(direction) < 0.12) {
            highest = std::max(highest, ball.z());
          }
          if (highest < 0.15 && from_robot.dot(direction) > 0.08 && std::abs(from_robot.dot(across)) < 0.06) {
            passed = true;
          }
        }
        if (passed) ++sweep.through;
        ++sweep.shots;
      }
    }
  }
  return sweep;
}

// How deep the ball is in a box [m]; negative outside.
double depth(const physics::Fixture& box, const world::Vector3d& ball) {
  const world::Vector3d nearest = ball.cwiseMax(box.min).cwiseMin(box.max);
  if (nearest != ball) return 0.0215 - (ball - nearest).norm();
  return 0.0215 + (ball - box.min).cwiseMin(box.max - ball).minCoeff();
}

// From all sides and above at a goal: nothing may get in but through the mouth.
Sweep chips_at_goal(double speed, double angle) {
  Sweep sweep;
  const auto fixtures = physics::fixtures(world::Field{});
  for (int side = 0; side < 24; ++side) {
    for (int distance = 0; distance < 6; ++distance) {
      for (int phase = 0; phase < sweep_phases / 4; ++phase) {
        Arena arena;
        const Vector2d direction = world::direction(side * 2 * M_PI / 24 + 0.01);
        const Vector2d from =
            start({4.6, 0.1}, direction, 0.75 + 0.16 * distance, speed, 4 * phase, world::substep_length);
        if (std::abs(from.x()) > 5.1) continue;  // beyond the wall
        const Vector2d flat = direction * (speed * std::cos(angle));
        arena.place({from.x(), from.y(), 0.0215}, {flat.x(), flat.y(), speed * std::sin(angle)});
        bool through_mouth = false, inside = false;
        world::Vector3d before = arena.ball().position;
        for (int i = 0; i < 240; ++i) {
          arena.step();
          const world::Vector3d ball = arena.ball().position;
          if ((before.x() - 4.5) * (ball.x() - 4.5) <= 0) {
            const world::Vector3d at =
                before + (ball - before) * ((4.5 - before.x()) / (ball.x() - before.x()));
            through_mouth = through_mouth || (std::abs(at.y()) < 0.5 && at.z() < 0.165);
          }
          inside =
              inside || (ball.x() > 4.51 && ball.x() < 4.67 && std::abs(ball.y()) < 0.49 && ball.z() < 0.14);
          for (const physics::Fixture& fixture : fixtures) {
            if (fixture.kind != physics::Fixture::Kind::Wall) {
              sweep.worst = std::max(sweep.worst, depth(fixture, ball));
            }
          }
          before = ball;
        }
        if (inside && !through_mouth) ++sweep.through;
        ++sweep.shots;
      }
    }
  }
  return sweep;
}

// A robot that drives backwards (its round side ahead) into something, at all headings that lead there.
Sweep robot_into(double speed, const Vector2d& at, const std::vector<Vector2d>& directions,
                 const std::vector<Arena::At>& others) {
  Sweep sweep;
  const world::Field field;
  const auto fixtures = physics::fixtures(field);
  for (const Vector2d& direction : directions) {
    for (int phase = 0; phase < sweep_phases; ++phase) {
      const double heading = world::angle_of(-direction);
      std::vector<Arena::At> places = {
          {start(at, direction, 0.35, speed, phase, world::substep_length), heading}};
      places.insert(places.end(), others.begin(), others.end());
      world::RobotSpecs fast;
      fast.max_speed = speed;
      Arena arena(places, fast);
      arena.world.set_motion(0, direction * speed, 0);
      world::RobotCommand on;
      on.velocity_local = {-speed, 0};
      arena.world.set_command(0, on);
      bool passed = false;
      for (int i = 0; i < 96; ++i) {
        arena.step();
        arena.world.read_robots(arena.robots);
        const Vector2d place = arena.robots[0].position;
        for (const physics::Fixture& fixture : fixtures) {
          if (fixture.min.z() > 0.15) continue;
          const double distance = physics::plane_distance(fixture, place);
          sweep.worst = std::max(sweep.worst, 0.09 - distance);
          passed = passed || distance == 0;
        }
        for (std::size_t other = 1; other < arena.robots.size(); ++other) {
          const double distance = (arena.robots[other].position - place).norm();
          sweep.worst = std::max(sweep.worst, 0.18 - distance);
          passed = passed || distance < 0.09;
        }
      }
      if (passed) ++sweep.through;
      ++sweep.shots;
    }
  }
  return sweep;
}

// Bullet sees an overlap only after it has happened, so it can be as deep as one step's travel, 33 mm at
// 8 m/s; corners of the hull lie off the nominal circle by 0.7 mm, and a slanting ball slides on for a step
// while it is pushed out. Walls, 0.2 m thick, are left to single steps at any speed.
double deepest(const std::string& what, double speed) {
  return (what == "wall" ? speed : 8) * world::substep_length + 0.003;
}

void expect_stopped(const char* what, const Sweep& sweep, double speed) {
  std::printf("%s at %.0f m/s: %d shots, worst overlap %.1f mm\n", what, speed, sweep.shots,
              sweep.worst * 1000);
  EXPECT_EQ(sweep.through, 0) << what << " at " << speed;
  EXPECT_LT(sweep.worst, deepest(what, speed)) << what << " at " << speed;
}

TEST(Tunnelling, NoBallPassesThroughARobot) {
  for (const double speed : {4.9, 8.0, 10.0}) {
    expect_stopped("resting robot", shots_at_robot(speed, 0), speed);
    expect_stopped("coming robot", shots_at_robot(speed, 3), speed);
  }
}
TEST(Tunnelling, NoBallPassesThroughAWall) {
  for (const double speed : {8.0, 10.0}) expect_stopped("wall", shots_at_wall(speed), speed);
}
TEST(Tunnelling, NoBallPassesThroughAGoal) {
  for (const double speed : {8.0, 10.0}) expect_stopped("goal", shots_at_goal(speed), speed);
}

TEST(Tunnelling, NoChipPassesThroughARobotOrAGoal) {
  for (const double speed : {6.0, 8.0}) {  // chips end at 6 m/s; 8 is what a law-abiding kick may have
    for (const double angle : {0.15, M_PI / 4, 1.0}) {
      expect_stopped("chip at robot", chips_at_robot(speed, angle), speed);
      expect_stopped("chip at goal", chips_at_goal(speed, angle), speed);
    }
  }
}

TEST(Tunnelling, NoRobotPassesThroughAWallAGoalOrARobot) {
  std::vector<Vector2d> fan;  // 75 degrees to both sides of +x
  for (int i = -5; i <= 5; ++i) fan.push_back(world::direction(i * M_PI / 12));
  const auto turned = [&](double angle) {
    std::vector<Vector2d> all;
    for (const Vector2d& direction : fan) all.push_back(world::rotated(direction, angle));
    return all;
  };
  // A robot enters an obstacle by at most its way in one substep: 13 mm at 3 m/s, 17 at 4; corners of its
  // hull stick out by 0.7 mm, and a rammed resting robot gives way.
  for (const double speed : {3.0, 4.0}) {
    const auto expect = [&](const char* what, const Sweep& sweep) {
      std::printf("robot into %s at %.0f m/s: %d times, worst overlap %.1f mm\n", what, speed, sweep.shots,
                  sweep.worst * 1000);
      EXPECT_EQ(sweep.through, 0) << what << " at " << speed;
      EXPECT_LT(sweep.worst, speed * world::substep_length + 0.004) << what << " at " << speed;
    };
    expect("wall", robot_into(speed, {5.1, 1.5}, fan, {}));
    expect("corner", robot_into(speed, {5.1, 3.6}, {world::direction(M_PI / 4), world::direction(0.4)}, {}));
    expect("post", robot_into(speed, {4.41, 0.52}, fan, {}));
    expect("goal side", robot_into(speed, {4.6, 0.64}, turned(-M_PI / 2), {}));
    expect("goal back from within", robot_into(speed, {4.58, 0}, {{1, 0}, world::direction(0.2)}, {}));
    expect("resting robot", robot_into(speed, {0, 0}, fan, {{{0.16, 0}, 0.3}}));
    expect("robot at a wall",
           robot_into(speed, {4.9, 1.5}, {{1, 0}, world::direction(0.2)}, {{{5.2 - 0.075, 1.5}, 0}}));
  }
}

TEST(Tunnelling, NoRobotPassesThroughAnotherHeadOn) {
  // Full speed head-on, 6 m/s closing, at eight headings and sixteen sweep_phases.
  double worst = 0;
  for (int side = 0; side < 8; ++side) {
    for (int phase = 0; phase < sweep_phases; ++phase) {
      const double shift = 3 * world::substep_length * phase / sweep_phases;
      Arena arena({{{-0.3 - shift, 0}, side * M_PI / 4}, {{0.3, 0.02}, M_PI}});
      arena.world.set_motion(0, {3, 0}, 0);
      arena.world.set_motion(1, {-3, 0}, 0);
      world::RobotCommand command;
      command.velocity_local = world::rotated({3, 0}, -side * M_PI / 4);
      arena.world.set_command(0, command);
      command.velocity_local = {3, 0};
      arena.world.set_command(1, command);
      for (int i = 0; i < 48; ++i) {
        arena.step();
        const Vector2d between = arena.robot(1).position - arena.robot(0).position;
        ASSERT_GT(between.x(), 0.1);
        worst = std::max(worst, 0.146 - between.norm());  // less than front to front is certainly overlap
      }
    }
  }
  std::printf("robots head-on at 3 m/s each: worst overlap %.1f mm beyond front to front\n", worst * 1000);
  EXPECT_LT(worst, 6 * world::substep_length);
}

}  // namespace

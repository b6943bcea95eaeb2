#include "sim/physics/actuators.h"

#include <gtest/gtest.h>

#include "tests/sim/physics/arena.h"

namespace {

using physics::ActuatorErrors;
using physics::Actuators;
using world::RobotId;
using world::Team;
using world::Vector2d;

constexpr double at_front = 0.073 + 0.0215;
constexpr int many = 4000;

// Mean and standard deviation with their standard errors: sigma / sqrt(n) and sigma / sqrt(2 n). Cutting a
// Gaussian at 3 sigma makes it 0.3 % narrower, which is allowed for besides. Four standard errors: one false
// alarm in 16 000, and the seeds are fixed.
struct Sample {
  std::vector<double> values;
  double mean() const {
    double sum = 0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(values.size());
  }
  double sigma() const {
    double sum = 0;
    for (const double value : values) sum += (value - mean()) * (value - mean());
    return std::sqrt(sum / static_cast<double>(values.size() - 1));
  }
  void expect(double expected_mean, double expected_sigma) const {
    const double n = static_cast<double>(values.size());
    EXPECT_NEAR(mean(), expected_mean, 4 * expected_sigma / std::sqrt(n));
    EXPECT_NEAR(sigma(), expected_sigma, expected_sigma * (4 / std::sqrt(2 * n) + 0.003));
    for (const double value : values) {
      ASSERT_LE(std::abs(value - expected_mean), 3 * expected_sigma * (1 + 1e-12));
    }
  }
};

ActuatorErrors all_errors() {
  ActuatorErrors errors;
  errors.kick_direction_sigma = 0.02;
  errors.kick_speed_sigma = 0.05;
  errors.chip_angle_sigma = 0.04;
  errors.misfire = 0.1;
  errors.grip_sigma = 0.2;
  errors.speed_sigma = 0.02;
  errors.acceleration_sigma = 0.05;
  errors.heading_drift_sigma = 0.03;
  return errors;
}

TEST(Actuators, KicksScatterAsTheyShould) {
  const Actuators actuators(all_errors(), {Team::Yellow, 3}, 1);
  Sample direction, speed, chip;
  int misfires = 0;
  for (int i = 0; i < many; ++i) {
    const physics::KickError error = actuators.kick(i);
    direction.values.push_back(error.direction);
    speed.values.push_back(error.speed_factor);
    chip.values.push_back(error.chip_angle);
    misfires += error.misfires ? 1 : 0;
  }
  direction.expect(0, 0.02);
  speed.expect(1, 0.05);
  chip.expect(0, 0.04);
  EXPECT_NEAR(misfires, 0.1 * many, 4 * std::sqrt(many * 0.1 * 0.9));
  // Direction and speed are independent: their correlation has a standard error of 1 / sqrt(n).
  double product = 0;
  for (std::size_t i = 0; i < many; ++i) product += direction.values[i] * (speed.values[i] - 1);
  EXPECT_NEAR(product / many / (0.02 * 0.05), 0, 4 / std::sqrt(many));
}

TEST(Actuators, GripScattersFromCaptureToCapture) {
  const Actuators actuators(all_errors(), {Team::Blue, 0}, 5);
  Sample grip;
  for (int i = 0; i < many; ++i) grip.values.push_back(actuators.grip_factor(i));
  grip.expect(1, 0.2);
}

TEST(Actuators, RobotsOfAGameAndGamesOfARobotDiffer) {
  Sample speed, acceleration, drift;
  for (std::uint64_t seed = 0; seed < 250; ++seed) {
    for (std::uint8_t number = 0; number < 16; ++number) {
      const Actuators actuators(all_errors(), {number % 2 == 0 ? Team::Yellow : Team::Blue, number}, seed);
      speed.values.push_back(actuators.speed_factor());
      acceleration.values.push_back(actuators.acceleration_factor());
      drift.values.push_back(actuators.heading_drift());
    }
  }
  speed.expect(1, 0.02);
  acceleration.expect(1, 0.05);
  drift.expect(0, 0.03);
  // Neighbours in a game are independent: correlation of one robot's factor with the next one's.
  double product = 0;
  for (std::size_t i = 1; i < speed.values.size(); ++i) {
    product += (speed.values[i] - 1) * (speed.values[i - 1] - 1);
  }
  EXPECT_NEAR(product / many / (0.02 * 0.02), 0, 4 / std::sqrt(many));
}

TEST(Actuators, OneRobotsKicksDoNotDependOnAnothers) {
  const RobotId ids[] = {{Team::Yellow, 1}, {Team::Blue, 1}, {Team::Yellow, 11}};
  std::vector<double> products(3, 0);
  for (int i = 0; i < many; ++i) {
    double z[3];
    for (int k = 0; k < 3; ++k) z[k] = Actuators(all_errors(), ids[k], 9).kick(i).direction / 0.02;
    products[0] += z[0] * z[1];
    products[1] += z[1] * z[2];
    products[2] += z[2] * z[0];
  }
  for (const double product : products) EXPECT_NEAR(product / many, 0, 4 / std::sqrt(many));
}

TEST(Actuators, OneErrorChangedLeavesTheOthersAsTheyWere) {
  ActuatorErrors less = all_errors();
  less.kick_direction_sigma = 0;
  less.misfire = 0;
  less.speed_sigma = 0;
  const Actuators one(all_errors(), {Team::Blue, 7}, 3), other(less, {Team::Blue, 7}, 3);
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(other.kick(i).direction, 0);
    EXPECT_FALSE(other.kick(i).misfires);
    EXPECT_EQ(one.kick(i).speed_factor, other.kick(i).speed_factor);
    EXPECT_EQ(one.kick(i).chip_angle, other.kick(i).chip_angle);
    EXPECT_EQ(one.grip_factor(i), other.grip_factor(i));
  }
  EXPECT_EQ(other.speed_factor(), 1);
  EXPECT_EQ(one.acceleration_factor(), other.acceleration_factor());
  EXPECT_EQ(one.heading_drift(), other.heading_drift());
}

TEST(Actuators, NoErrorsMeanNone) {
  const Actuators perfect({}, {Team::Yellow, 0}, 77);
  EXPECT_EQ(perfect.speed_factor(), 1);
  EXPECT_EQ(perfect.acceleration_factor(), 1);
  EXPECT_EQ(perfect.heading_drift(), 0);
  EXPECT_EQ(perfect.grip_factor(12), 1);
  const physics::KickError error = perfect.kick(12);
  EXPECT_EQ(error.direction, 0);
  EXPECT_EQ(error.speed_factor, 1);
  EXPECT_EQ(error.chip_angle, 0);
  EXPECT_FALSE(error.misfires);
}

// One robot kicks again and again; the ball is put back before each kick.
struct Range {
  explicit Range(const ActuatorErrors& errors) : arena({{{0, 0}, 0}}, {}, with(errors), 1) {}
  static physics::Params with(const ActuatorErrors& errors) {
    physics::Params params;
    params.actuators = errors;
    return params;
  }
  void shoot(int count, double speed, double angle = 0) {
    world::RobotCommand command;
    command.kick_speed = speed;
    command.kick_angle = angle;
    for (int i = 0; i < count; ++i) {
      arena.world.put_robot(0, {0, 0}, 0);  // charged
      arena.world.set_command(0, command);
      arena.world.place_ball(Vector2d(at_front, 0));
      arena.step();
    }
  }
  Arena arena;
};

TEST(Actuators, TheWorldsKicksScatterByTheErrors) {
  ActuatorErrors errors;
  errors.kick_direction_sigma = 0.02;
  errors.kick_speed_sigma = 0.05;
  Range range(errors);
  range.shoot(1000, 5);
  ASSERT_EQ(range.arena.kicks.size(), 1000U);
  Sample direction, speed;
  for (const truth::Kick& kick : range.arena.kicks) {
    direction.values.push_back(world::angle_of(kick.velocity.head<2>()));
    speed.values.push_back(kick.velocity.norm() / 5);
    EXPECT_EQ(kick.velocity.z(), 0);
  }
  direction.expect(0, 0.02);
  speed.expect(1, 0.05);
}

TEST(Actuators, ChipsScatterInElevationAndStayChips) {
  ActuatorErrors errors;
  errors.chip_angle_sigma = 0.04;
  Range range(errors);
  range.shoot(1000, 5, 0.8);
  Sample elevation;
  for (const truth::Kick& kick : range.arena.kicks) {
    elevation.values.push_back(std::asin(kick.velocity.z() / kick.velocity.norm()));
    EXPECT_NEAR(kick.velocity.norm(), 5, 1e-9);
  }
  elevation.expect(0.8, 0.04);
  range.arena.kicks.clear();
  range.shoot(200, 9, 0.01);  // nearly flat: the cap of chips holds, no ball is pressed into the carpet
  for (const truth::Kick& kick : range.arena.kicks) {
    EXPECT_GE(kick.velocity.z(), 0);
    EXPECT_LE(kick.velocity.norm(), 6 + 1e-9);
  }
}

TEST(Actuators, NoKickIsFasterThanTheRobotCan) {
  ActuatorErrors errors;
  errors.kick_speed_sigma = 0.2;
  Range range(errors);
  range.shoot(500, 9.9);
  int at_cap = 0;
  for (const truth::Kick& kick : range.arena.kicks) {
    EXPECT_LE(kick.velocity.norm(), 10 + 1e-9);
    at_cap += kick.velocity.norm() > 10 - 1e-9 ? 1 : 0;
  }
  EXPECT_GT(at_cap, 100);  // about half of them would have been
}

TEST(Actuators, AMisfireUsesUpTheChargeAndMovesNothing) {
  ActuatorErrors errors;
  errors.misfire = 1;
  Range range(errors);
  range.shoot(1, 5);
  EXPECT_TRUE(range.arena.kicks.empty());
  EXPECT_EQ(range.arena.ball().velocity.norm(), 0);
  EXPECT_EQ(range.arena.world.state().robots[0].memory.recharging, 24);
  EXPECT_EQ(range.arena.world.state().robots[0].memory.kicks, 1);
}

TEST(Actuators, WithoutErrorsTheSeedDoesNotMatterToTheBit) {
  const auto end_of_scrum = [](std::uint64_t seed, const ActuatorErrors& errors) {
    Arena arena({{{-0.3, 0}, 0}, {{0.3, 0.02}, 3}}, {}, Range::with(errors), seed);
    arena.world.place_ball(Vector2d(0, 0));
    for (int i = 0; i < 480; ++i) {
      for (std::size_t k = 0; k < 2; ++k) {
        world::RobotCommand command;
        command.velocity_local = {1, 0.2};
        command.angular_velocity = std::sin(0.02 * i);
        command.dribbler_speed = i % 100 < 50 ? 100 : 0;
        command.kick_speed = i % 100 > 70 ? 2 : 0;
        command.kick_angle = i % 200 > 100 ? 0.6 : 0;
        arena.world.set_command(k, command);
      }
      arena.step();
    }
    EXPECT_FALSE(arena.kicks.empty());
    return std::make_tuple(arena.ball().position, arena.ball().spin, arena.robot(0).position,
                           arena.robot(1).orientation);
  };
  EXPECT_EQ(end_of_scrum(1, {}), end_of_scrum(2, {}));
  EXPECT_NE(end_of_scrum(1, all_errors()), end_of_scrum(2, all_errors()));
}

TEST(Actuators, FactorsChangeWhatIsDriven) {
  ActuatorErrors errors;
  errors.speed_sigma = 0.05;
  errors.acceleration_sigma = 0.1;
  errors.heading_drift_sigma = 0.05;
  const Actuators same(errors, {Team::Yellow, 0}, 1);
  Arena arena({{{-2, 0}, 0}}, {}, Range::with(errors), 1);
  world::RobotCommand command;
  command.velocity_local = {2, 0};
  arena.world.set_command(0, command);
  arena.run(0.5);
  EXPECT_NEAR(arena.robot(0).velocity.norm(), 3 * same.acceleration_factor() * 0.5, 1e-3);
  arena.run(1.0);
  EXPECT_NEAR(arena.robot(0).velocity.norm(), 2 * same.speed_factor(), 1e-4);
  // The turn is drift times the way, while both grow from rest; the way is the arc's, here its chord.
  const double way = (arena.robot(0).position - Vector2d(-2, 0)).norm();
  EXPECT_NEAR(arena.robot(0).orientation, same.heading_drift() * way,
              0.02 * std::abs(same.heading_drift() * way));
}

TEST(Actuators, AsksForFullSpeedAreStillLimited) {
  ActuatorErrors errors;
  errors.speed_sigma = 0.1;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const Actuators same(errors, {Team::Yellow, 0}, seed);
    Arena arena({{{-4, 0}, 0}}, {}, Range::with(errors), seed);
    world::RobotCommand command;
    command.velocity_local = {3, 0};
    arena.world.set_command(0, command);
    arena.run(1.5);
    EXPECT_NEAR(arena.robot(0).velocity.norm(), std::min(3 * same.speed_factor(), 3.0), 1e-4);
  }
}

TEST(Actuators, GripDecidesWhereABallIsLost) {
  // The rate at which a turn in place loses the ball goes with the root of the grip:
  // the pull is what holds it.
  ActuatorErrors errors;
  errors.grip_sigma = 0.2;
  int lost = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Arena arena({{{0, 0}, 0}}, {}, Range::with(errors), seed);
    arena.world.place_ball(Vector2d(at_front, 0));
    world::RobotCommand command;
    command.dribbler_speed = 100;
    arena.world.set_command(0, command);
    arena.run(0.1);
    const double factor = arena.world.state().robots[0].memory.grip_factor;
    EXPECT_EQ(factor, Actuators(errors, {Team::Yellow, 0}, seed).grip_factor(0));
    command.angular_velocity = 6.5;  // w^2 rho = 4.0 of 5 m/s^2
    arena.world.set_command(0, command);
    arena.run(1);
    const bool held = arena.robot(0).ball_contact;
    if (factor > 0.90) {
      EXPECT_TRUE(held) << factor;
    }
    if (factor < 0.75) {
      EXPECT_FALSE(held) << factor;
    }
    lost += held ? 0 : 1;
  }
  EXPECT_GT(lost, 1);
  EXPECT_LT(lost, 20);
}

}  // namespace

#include "sim/engine/model.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/engine/line_up.h"

namespace {

using engine::Model;
using world::Team;

Model six_a_side() {
  Model model;
  for (const Team team : world::both_teams) {
    model.robots[team] = engine::standard_robots(team, {0, 1, 2, 3, 4, 5});
  }
  model.realism = engine::realism("none");
  return model;
}

std::string complaint(const Model& model) {
  try {
    engine::check(model);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(Model, OrdinaryOneIsAccepted) { EXPECT_EQ(complaint(six_a_side()), ""); }

TEST(Model, ComplaintsNameTeamRobotFieldAndValue) {
  Model model = six_a_side();
  model.robots[Team::Blue][2].mass = -1;
  EXPECT_THAT(complaint(model), testing::AllOf(testing::HasSubstr("blue robot 2"), testing::HasSubstr("mass"),
                                               testing::HasSubstr("-1")));
  model = six_a_side();
  model.robots[Team::Blue][2].id.number = 1;
  EXPECT_THAT(complaint(model), testing::HasSubstr("blue robot 1 is there twice"));
  model = six_a_side();
  model.robots[Team::Blue][2].id.number = 16;
  EXPECT_THAT(complaint(model), testing::HasSubstr("0 to 15"));
  model = six_a_side();
  model.robots[Team::Blue][2].id.team = Team::Yellow;
  EXPECT_THAT(complaint(model), testing::HasSubstr("its id says yellow"));
  model = six_a_side();
  model.robots[Team::Yellow].resize(17);
  EXPECT_THAT(complaint(model), testing::HasSubstr("at most 16 robots, there are 17"));
  model = six_a_side();
  model.robots[Team::Yellow][0].max_kick_speed = 20;
  EXPECT_THAT(complaint(model), testing::HasSubstr("max_kick_speed"));
  model = six_a_side();
  model.geometry.field.boundary_width = 0.2;
  EXPECT_THAT(complaint(model), testing::HasSubstr("boundary_width"));
  model = six_a_side();
  model.realism.radio.latency = -1;
  EXPECT_THAT(complaint(model), testing::HasSubstr("radio.latency"));
}

TEST(StandardRobots, AreSlowedByTheirFactor) {
  const auto robots = engine::standard_robots(Team::Blue, {4, 9}, 0.5);
  ASSERT_EQ(robots.size(), 2U);
  EXPECT_EQ(robots[1].id, (world::RobotId{Team::Blue, 9}));
  EXPECT_EQ(robots[0].max_speed, 1.5);
  EXPECT_EQ(robots[0].max_brake, 3.0);
  for (const double factor : {0.0, -1.0, 11.0, std::nan("")}) {
    EXPECT_THROW(engine::standard_robots(Team::Blue, {0}, factor), std::invalid_argument) << factor;
  }
  EXPECT_THROW(engine::standard_robots(Team::Blue, {16}), std::invalid_argument);
}

TEST(Realism, PresetsAreKnownByName) {
  EXPECT_EQ(engine::realism("none").vision.ball_sigma, 0);
  EXPECT_EQ(engine::realism("none").radio.latency, 1);
  EXPECT_EQ(engine::realism("measured").vision.ball_sigma, 0.0005);
  EXPECT_EQ(engine::realism("measured").vision.robot_sigma, 0.00055);
  EXPECT_EQ(engine::realism("measured").vision.orientation_sigma, 0.0035);
  EXPECT_EQ(engine::realism("measured").vision.delay, 1);
  EXPECT_EQ(engine::realism("friendly").vision.delay, 0);
  EXPECT_EQ(engine::realism("harsh").radio.latency, 2);
  try {
    engine::realism("real");
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), testing::AllOf(testing::HasSubstr("\"real\""), testing::HasSubstr("measured")));
  }
}

TEST(LineUp, SixteenRobotsStandApartInTheirOwnHalf) {
  const world::Field field;
  for (const world::Side side : {world::Side::Negative, world::Side::Positive}) {
    const auto poses = engine::line_up(field, side, 16);
    ASSERT_EQ(poses.size(), 16U);
    for (std::size_t a = 0; a < poses.size(); ++a) {
      EXPECT_GT(poses[a].position.x() * world::sign(side), field.robot_radius);
      EXPECT_LT(std::abs(poses[a].position.x()), field.half_length());
      EXPECT_LT(std::abs(poses[a].position.y()), field.half_width());
      EXPECT_GT(poses[a].position.norm(), 0.5 + field.robot_radius);
      for (std::size_t b = a + 1; b < poses.size(); ++b) {
        EXPECT_GT((poses[a].position - poses[b].position).norm(), 0.25);
      }
    }
    EXPECT_EQ(poses[0].position.y(), 0);
    EXPECT_NEAR(std::abs(poses[0].position.x()), field.half_length() - field.robot_radius, 1e-12);
  }
}

}  // namespace

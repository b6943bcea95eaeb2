#include "experiments/host/robot_count.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/engine/realism.h"

namespace host {
namespace {

using testing::ElementsAre;
using world::Team;

class RobotCountTest : public testing::Test {
 protected:
  RobotCountTest() : engine_(model()) {
    state_.location = world::Location::GameOff;
    message_.teams.yellow.keeper = 9;
    message_.teams.yellow.max_robots = 4;
    message_.teams.blue.max_robots = 2;
  }
  static engine::Model model() {
    engine::Model model;
    model.robots.yellow = engine::standard_robots(Team::Yellow, {1, 3, 7, 9});
    model.robots.blue = engine::standard_robots(Team::Blue, {0, 1});
    model.realism = engine::realism("none");
    return model;
  }
  void run(int ticks) {
    for (int i = 0; i < ticks; ++i) {
      engine_.step({});
      count_.update(message_, state_, engine_);
    }
  }
  std::vector<int> yellow() const {
    std::vector<int> numbers;
    for (const auto& robot : engine_.truth().robots) {
      if (robot.id.team == Team::Yellow) numbers.push_back(robot.id.number);
    }
    return numbers;
  }

  engine::Engine engine_;
  world::RefereeMessage message_;
  world::GameState state_;
  RobotCount count_;
};

TEST_F(RobotCountTest, ChangesNothingWhileTheNumberIsRight) {
  run(10);
  EXPECT_THAT(yellow(), ElementsAre(1, 3, 7, 9));
}

TEST_F(RobotCountTest, TakesTheHighestNumberButNotTheKeeper) {
  message_.teams.yellow.max_robots = 3;
  run(10);
  EXPECT_THAT(yellow(), ElementsAre(1, 3, 9));
  message_.teams.yellow.max_robots = 1;
  run(10);
  EXPECT_THAT(yellow(), ElementsAre(9));
}

TEST_F(RobotCountTest, TakesTheOneTheTeamNames) {
  count_.prefer({Team::Yellow, 1});
  message_.teams.yellow.max_robots = 3;
  run(10);
  EXPECT_THAT(yellow(), ElementsAre(3, 7, 9));
}

TEST_F(RobotCountTest, WaitsForGameOff) {
  message_.teams.yellow.max_robots = 3;
  state_.location = world::Location::GameOn;
  run(10);
  EXPECT_THAT(yellow(), ElementsAre(1, 3, 7, 9));
}

TEST_F(RobotCountTest, LetsThemBackInAtTheHalfwayLineOutsideTheTouchLine) {
  message_.teams.yellow.max_robots = 2;
  run(10);
  message_.teams.yellow.max_robots = 4;
  run(2);
  EXPECT_THAT(yellow(), ElementsAre(1, 3, 7, 9));
  const world::Field field;
  for (const auto& robot : engine_.truth().robots) {
    if (robot.id != world::RobotId{Team::Yellow, 3} && robot.id != world::RobotId{Team::Yellow, 7}) continue;
    EXPECT_LT(std::abs(robot.position.x()), 0.5);                             // two places in the own half
    EXPECT_LT(robot.position.x(), 0);                                         // yellow defends -x
    EXPECT_LT(robot.position.y(), -field.half_width() - field.robot_radius);  // wholly outside
    EXPECT_GT(robot.position.y(), -field.half_width() - field.boundary_width + field.robot_radius);
  }
}

}  // namespace
}  // namespace host
